#include <iostream>
#include <memory>
#include <stop_token>
#include <thread>

#include "app/cli/serve_commands.h"
#include "app/robot_option/robot_option.h"
#include "core/common/resources.h"
#include "core/devices/fri_datagram.h"
#include "core/devices/igtl_robot_host.h"
#include "core/devices/real_time.h"
#include "core/robot/kinematics.h"
#include "core/robot/urdf.h"
#include "core/simulation/bench_layout.h"
#include "core/simulation/simulated_robot.h"

namespace mirrorarm::cli {
namespace {

constexpr std::chrono::milliseconds kLookEvery{100};
constexpr Seconds kForEver = std::chrono::hours(24 * 365);

struct Wish {
  devices::IgtlRobotHostSettings host;
  app::RobotOption robot;
  std::filesystem::path arm = resourceFolder() / "robots/lbr4plus.urdf";
  double period_ms = 4.0;
  double seconds = 0.0;
  std::uint64_t seed = 1;
};

std::unique_ptr<robot::RobotLink> simulatedRobot(const robot::ArmDescription& arm, const TimeSource& time,
                                                 std::uint64_t seed) {
  const auto posture = simulation::bench_layout::startPosture(robot::Kinematics(arm));
  return std::make_unique<simulation::SimulatedRobot>(
      arm, posture.value_or(robot::Joints(robot::Joints::Zero(arm.jointCount()))), time,
      simulation::SimulatedRobotSettings{.seed = seed});
}

std::unique_ptr<robot::RobotLink> robotOf(const Wish& wish, const robot::ArmDescription& arm,
                                          const TimeSource& time) {
  if (wish.robot.isSimulated()) return simulatedRobot(arm, time, wish.seed);
  if (wish.robot.robot.starts_with("fri:") && arm.joints.size() != devices::kFriJoints)
    throw InputRefused(wish.arm.string() + ": FRI drives arms of seven joints");
  auto link = app::openRobot(wish.robot);
  if (!link) throw CommandFailed(link.error());
  return std::move(*link);
}

void tell(const devices::IgtlRobotHostReport& report, Context& context) {
  auto& refused = context.result["refused"] = nlohmann::ordered_json::object();
  for (std::size_t i = 0; i < devices::kRobotRefusals; ++i)
    refused[std::string(id(static_cast<devices::RobotRefusal>(i)))] = report.refused[i];
  context.result["states"] = report.states;
  context.result["commands"] = report.commands;
  context.result["callers"] = report.callers;
  context.result["turned_away"] = report.turned_away;
  context.result["stops"] = report.stops;
  if (!context.json)
    std::cout << report.callers << " clients, " << report.states << " states told, " << report.commands
              << " commands taken, " << report.stops << " stops\n";
}

void serveRobot(Wish& wish, Context& context) {
  const auto arm = orRefuse(robot::readUrdf(wish.arm));
  const SteadyTime time;
  const auto robot = robotOf(wish, arm, time);
  wish.host.period = Seconds(1e-3 * wish.period_ms);
  const auto host = devices::IgtlRobotHost::open(wish.host, arm, *robot);
  if (!host) throw CommandFailed(host.error());
  catchInterrupt();
  const auto grant = devices::askForRealTime();
  std::cerr << "serving " << wish.robot.robot << " on port " << (*host)->port()
            << (wish.host.allow_motion ? "" : ", without motion") << "; " << schedulingLine(grant) << "\n";
  std::stop_source end;
  const std::jthread watcher([&end](const std::stop_token& done) {
    while (!isInterrupted() && !done.stop_requested()) std::this_thread::sleep_for(kLookEvery);
    end.request_stop();
  });
  (*host)->run(end.get_token(), wish.seconds > 0.0 ? Seconds(wish.seconds) : kForEver);
  tell((*host)->report(), context);
}

}  // namespace

void addServeRobot(CLI::App& serve, Context& context) {
  CLI::App* command = addCommand(serve, context, "robot", "Lend a robot to one client over OpenIGTLink",
                                 "mirrorarm-cli serve robot --robot fri:192.168.0.100:49938 --address "
                                 "10.0.0.2 --allow 10.0.0.1 --allow-motion");
  const auto wish = std::make_shared<Wish>();
  app::addRobotOption(*command, wish->robot);
  command->add_option("--arm", wish->arm, "URDF of the arm: its ranges and speeds are kept")
      ->capture_default_str();
  command->add_option("--address", wish->host.address, "Own address to listen at")->capture_default_str();
  command->add_option("--port", wish->host.port, "Own port")->capture_default_str();
  command->add_option("--allow", wish->host.allowed, "Hosts that may connect")->capture_default_str();
  command->add_flag("--allow-motion", wish->host.allow_motion, "The client may move the robot");
  command->add_option("--period-ms", wish->period_ms, "Between states, and between commands")
      ->check(CLI::Range(1.0, 100.0))
      ->capture_default_str();
  command->add_option("--seconds", wish->seconds, "How long; 0 until interrupted")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command->add_option("--seed", wish->seed, "Of the simulated robot's noise")->capture_default_str();
  command->callback([wish, &context] { serveRobot(*wish, context); });
}

}  // namespace mirrorarm::cli
