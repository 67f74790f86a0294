#include <csignal>
#include <filesystem>
#include <iostream>
#include <stdexcept>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "core/common/csv.h"
#include "core/common/resources.h"
#include "core/devices/real_time.h"
#include "core/peers/fri_controller_host.h"
#include "core/robot/kinematics.h"
#include "core/robot/urdf.h"
#include "core/simulation/bench_layout.h"

namespace {

using namespace mirrorarm;

constexpr int kDone = 0, kFailed = 1, kWrongUse = 2;
/// How long the controller is left alone before it looks whether it is to end.
constexpr Seconds kLookEvery{0.1};

volatile std::sig_atomic_t interrupted = 0;

class InputRefused : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct Options {
  peers::FriControllerHostSettings host;
  std::filesystem::path arm = resourceFolder() / "robots/lbr4plus.urdf";
  std::string start_deg;  ///< empty: where the simulated bench begins
  std::vector<std::string> faults;
  std::filesystem::path fault_file;
  double period_ms = 1.0;
  double seconds = 0.0;
  bool json = false;
};

robot::ArmDescription armOf(const Options& options) {
  const auto arm = robot::readUrdf(options.arm);
  if (!arm) throw InputRefused(describe(arm.error()));
  if (arm->joints.size() != devices::kFriJoints)
    throw InputRefused(options.arm.string() + ": FRI drives arms of seven joints");
  return *arm;
}

robot::Joints benchStart(const Options& options, const robot::ArmDescription& arm) {
  const auto start = simulation::bench_layout::startPosture(robot::Kinematics(arm));
  if (!start)
    throw InputRefused("--start: is wanted, for " + options.arm.string() +
                       " does not reach where the simulated bench begins");
  return *start;
}

robot::Joints startOf(const Options& options, const robot::ArmDescription& arm) {
  if (options.start_deg.empty()) return benchStart(options, arm);
  const auto cells = splitCells(options.start_deg, ',');
  robot::Joints start(devices::kFriJoints);
  for (std::size_t i = 0; i < devices::kFriJoints; ++i) {
    double angle_deg = 0.0;
    if (cells.size() != devices::kFriJoints || !parseNumber(cells[i], angle_deg))
      throw InputRefused("--start: '" + options.start_deg + "' is not seven angles in degrees");
    const double angle_rad = angle_deg * EIGEN_PI / 180.0;
    if (angle_rad < arm.joints[i].lower_rad || angle_rad > arm.joints[i].upper_rad)
      throw InputRefused("--start: " + cells[i] + " is beyond the range of joint " + arm.joints[i].name);
    start[static_cast<Eigen::Index>(i)] = angle_rad;
  }
  return start;
}

std::vector<peers::FriFault> faultsOf(const Options& options) {
  std::vector<peers::FriFault> faults;
  if (!options.fault_file.empty()) {
    const auto read = peers::readFriFaults(options.fault_file);
    if (!read) throw InputRefused(describe(read.error()));
    faults = *read;
  }
  for (const std::string& text : options.faults) {
    const auto fault = peers::friFaultOf(text);
    if (!fault) throw InputRefused("--fault: " + fault.error());
    faults.push_back(*fault);
  }
  return faults;
}

nlohmann::ordered_json jsonOf(const peers::FriControllerHost& host) {
  const auto& controller = host.controller();
  const auto& report = controller.report();
  nlohmann::ordered_json falls = nlohmann::ordered_json::array();
  for (const auto& fall : report.falls) falls.push_back({{"time_s", fall.time_s}, {"why", id(fall.why)}});
  return {{"cycles", report.cycles},
          {"in_time", report.in_time},
          {"missed", report.missed},
          {"late", report.late},
          {"doubled", report.doubled},
          {"out_of_order", report.out_of_order},
          {"refused", report.refused},
          {"mirror_errors", report.mirror_errors},
          {"starts", report.starts},
          {"falls", falls},
          {"skipped_beats", host.skippedBeats()},
          {"state", id(controller.state())},
          {"quality", id(controller.quality())},
          {"q_rad", std::vector<double>(controller.q().begin(), controller.q().end())}};
}

void run(Options& options) {
  const auto arm = armOf(options);
  options.host.controller.period = Seconds(1e-3 * options.period_ms);
  options.host.faults = faultsOf(options);
  const auto host = peers::FriControllerHost::open(options.host, arm, startOf(options, arm));
  if (!host) throw InputRefused(host.error());
  std::cerr << "calling " << options.host.host << ":" << options.host.port << "; "
            << schedulingLine(devices::askForRealTime()) << "\n";
  std::signal(SIGINT, [](int) { interrupted = 1; });
  std::signal(SIGTERM, [](int) { interrupted = 1; });
  const TimePoint begin = Clock::now();
  const std::stop_source never;
  while (interrupted == 0 &&
         (options.seconds == 0.0 || secondsBetween(begin, Clock::now()) < options.seconds))
    (*host)->run(never.get_token(), kLookEvery);
  const auto result = jsonOf(**host);
  if (options.json)
    std::cout << result.dump() << "\n";
  else
    for (const auto& [key, value] : result.items()) std::cout << key << ": " << value.dump() << "\n";
}

void addOptions(CLI::App& app, Options& options) {
  app.add_option("--host", options.host.host, "Who is to answer")->capture_default_str();
  app.add_option("--port", options.host.port, "And on which port")->capture_default_str();
  app.add_option("--address", options.host.address, "Own address")->capture_default_str();
  app.add_option("--period-ms", options.period_ms, "A cycle, as given to friOpen")
      ->check(CLI::Range(1.0, 100.0))
      ->capture_default_str();
  app.add_option("--robot", options.arm, "URDF of the arm")->capture_default_str();
  app.add_option(
      "--start", options.start_deg,
      "Angles to rest at [deg], as 0,45,0,-60,0,60,0; where the simulated bench begins unless given");
  app.add_option("--fault", options.faults, "[answer-]KIND[:SHARE][@FROM_S[+FOR_S]], as lost:0.01@5+2")
      ->delimiter(',');
  app.add_option("--faults", options.fault_file, "A file with one fault a line");
  app.add_option("--seconds", options.seconds, "How long; 0 until interrupted")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  app.add_option("--seed", options.host.seed, "For the faults")->capture_default_str();
  app.add_flag("--json", options.json, "Print one JSON object at the end");
  app.footer(
      "Kinds of faults: lost late duplicated reordered short long garbled wrong_id nan silence\n"
      "drive_error poor_quality start_pose.\n"
      "Example:\n  mirrorarm-fri-controller --port 49938 --fault silence@20+0.2 --seconds 60 --json");
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"A simulated controller of an LBR 4+ that speaks the Fast Research Interface 1.0",
               "mirrorarm-fri-controller"};
  app.set_version_flag("--version", MIRRORARM_VERSION);
  Options options;
  addOptions(app, options);
  try {
    app.parse(argc, argv);
    run(options);
    return kDone;
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    std::cerr << "mirrorarm-fri-controller: " << error.what() << " (--help shows how)\n";
    return kWrongUse;
  } catch (const InputRefused& refusal) {
    std::cerr << "mirrorarm-fri-controller: " << refusal.what() << "\n";
    return kWrongUse;
  } catch (const std::exception& failure) {
    std::cerr << "mirrorarm-fri-controller: " << failure.what() << "\n";
    return kFailed;
  }
}
