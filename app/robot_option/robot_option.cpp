#include "app/robot_option/robot_option.h"

#include <cassert>

#include "core/common/resources.h"
#include "core/devices/robot_address.h"
#include "core/robot/kinematics.h"
#include "core/simulation/bench_layout.h"

namespace mirrorarm::app {
namespace {

constexpr Seconds kPatience{5.0};  // for a connection, and for the first state

/// What CLI11 wants of a check: why not, or nothing.
std::string reasonAgainst(const std::string& word) {
  const auto address = devices::robotAddressOf(word);
  return address ? "" : address.error();
}

FromFile<robot::Joints> benchPosture() {
  const auto arm = simulation::bench_layout::arm(resourceFolder());
  if (!arm) return unexpected(arm.error());
  const auto start = simulation::bench_layout::startPosture(robot::Kinematics(*arm));
  if (!start)
    return unexpected(
        FileError{resourceFolder(), 0, "holds an arm that does not reach the bench's start pose"});
  return *start;
}

}  // namespace

void addRobotOption(CLI::App& app, RobotOption& option) {
  app.add_option("--robot", option.robot, "simulated, fri:[ADDRESS:]PORT or igtl:HOST[:PORT]")
      ->check(CLI::Validator(reasonAgainst, ""))
      ->capture_default_str();
  app.add_option("--controller", option.controller, "The only controller that is answered (fri)");
  app.add_option("--fri-period-ms", option.fri_period_ms, "A cycle of the controller, as given to friOpen")
      ->check(CLI::Range(1.0, 20.0))
      ->capture_default_str();
}

Expected<std::unique_ptr<robot::RobotLink>, std::string> openRobot(const RobotOption& option,
                                                                   robot::GivesWay gives_way) {
  assert(!option.isSimulated());
  const auto address = devices::robotAddressOf(option.robot);
  if (!address) return unexpected(address.error());
  devices::FriLinkSettings fri;
  fri.controller = option.controller;
  fri.session.period = Seconds(1e-3 * option.fri_period_ms);
  fri.session.gives_way = gives_way;
  return devices::openRobot(*address, fri, kPatience);
}

Expected<std::unique_ptr<simulation::RiddenRobot>, std::string> openBenchRobot(const RobotOption& option,
                                                                               robot::GivesWay gives_way) {
  using Robot = std::unique_ptr<simulation::RiddenRobot>;
  if (option.isSimulated()) return Robot();
  const auto start = benchPosture();
  if (!start) return unexpected(describe(start.error()));
  auto link = openRobot(option, gives_way);
  if (!link) return unexpected(option.robot + ": " + link.error());
  auto ridden = simulation::RiddenRobot::mount(std::move(*link), *start, kPatience);
  if (!ridden) return unexpected(option.robot + ": " + ridden.error());
  return std::move(*ridden);
}

}  // namespace mirrorarm::app
