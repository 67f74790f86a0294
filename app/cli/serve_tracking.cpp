#include <algorithm>
#include <iostream>
#include <memory>
#include <thread>

#include "app/cli/bench_points.h"
#include "app/cli/serve_commands.h"
#include "app/cli/target_files.h"
#include "app/cli/tracker_option.h"
#include "core/devices/igtl_tracking_host.h"
#include "core/tracking/tracker.h"

namespace mirrorarm::cli {
namespace {

using devices::IgtlTrackingHost;
using devices::TargetReport;
using devices::TargetSight;
using tracking::Target;
using tracking::TrackStatus;

constexpr Seconds kLookEvery{0.010};
constexpr Seconds kLastWords{1.0};

struct Wish {
  devices::IgtlTrackingHostSettings host;
  PointInput input;
  std::vector<std::filesystem::path> targets;
  tracking::TrackingMethod tracker = tracking::TrackerSettings{}.method;
  double seconds = 0.0;
  std::uint64_t seed = 1;

  [[nodiscard]] bool isLive() const { return input.recording.empty() && input.clouds.empty(); }
};

/// OpenIGTLink's headers hold 20 characters of plain ASCII.
void checkNames(const std::vector<Target>& targets) {
  for (const Target& target : targets) {
    const bool plain = std::ranges::all_of(target.name, [](char c) { return c >= ' ' && c <= '~'; });
    if (!plain || target.name.empty() || target.name.size() > devices::kMostTargetName)
      throw InputRefused("target '" + target.name + "': OpenIGTLink tells names of 1 to 20 plain characters");
  }
}

double calendarNow() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

TargetSight sightOf(TrackStatus status) {
  switch (status) {
    case TrackStatus::kTracked:
      return TargetSight::kTracked;
    case TrackStatus::kPredicted:
      return TargetSight::kPredicted;
    case TrackStatus::kLost:
      break;
  }
  return TargetSight::kLost;
}

/// Looks after the clients until `due`.
void greetUntil(TimePoint due, IgtlTrackingHost& host) {
  for (;;) {
    host.greet();
    const TimePoint now = Clock::now();
    if (now >= due || isInterrupted()) return;
    std::this_thread::sleep_until(std::min(due, now + toClock(kLookEvery)));
  }
}

/// A recording begins when somebody is there to hear it.
void awaitFirst(IgtlTrackingHost& host) {
  while (host.clients() == 0 && !isInterrupted()) greetUntil(Clock::now() + toClock(kLookEvery), host);
}

/// Tracks and tells frame after frame; how many they were.
class Service {
 public:
  Service(PointSource& source, const std::vector<Target>& targets, const Wish& wish, IgtlTrackingHost& host)
      : source_(source), wish_(wish), host_(host), targets_(targets), tracker_(settingsOf(wish)) {
    if (const auto* rig = source.rig()) tracker_.setRig(*rig);
    tracker_.setTargets(targets);
  }

  std::size_t run() {
    if (!wish_.isLive()) awaitFirst(host_);
    const TimePoint begin = Clock::now();
    calendar_s_ = calendarNow() - Seconds(begin.time_since_epoch()).count();
    std::size_t frames = 0;
    for (; frames < source_.size() && !isOver(begin); ++frames) {
      const PointFrame frame = source_.frame(frames);
      if (frames == 0) ahead_ = wish_.isLive() ? Clock::duration::zero() : begin - frame.exposed_at;
      greetUntil(frame.exposed_at + ahead_, host_);
      tell(frame);
    }
    const TimePoint end = Clock::now() + toClock(kLastWords);
    while (host_.isBehind() && Clock::now() < end) greetUntil(Clock::now() + toClock(kLookEvery), host_);
    return frames;
  }

 private:
  static tracking::TrackerSettings settingsOf(const Wish& wish) {
    tracking::TrackerSettings settings;
    settings.method = wish.tracker;
    return settings;
  }
  [[nodiscard]] bool isOver(TimePoint begin) const {
    return isInterrupted() || (wish_.seconds > 0.0 && secondsBetween(begin, Clock::now()) >= wish_.seconds);
  }
  void tell(const PointFrame& frame) {
    const auto answers = tracker_.track(frame.points, frame.exposed_at);
    const double time_s = calendar_s_ + Seconds((frame.exposed_at + ahead_).time_since_epoch()).count();
    reports_.clear();
    for (std::size_t t = 0; t < targets_.size(); ++t)
      reports_.push_back(
          {targets_[t].name, time_s, sightOf(answers[t].status), answers[t].X_CT, answers[t].covariance});
    host_.tell(reports_);
    tracker_.learn();
  }

  PointSource& source_;
  const Wish& wish_;
  IgtlTrackingHost& host_;
  const std::vector<Target>& targets_;
  tracking::Tracker tracker_;
  Clock::duration ahead_{};  ///< of this machine's clock before the recording's
  double calendar_s_ = 0.0;  ///< the calendar at the clock's epoch
  std::vector<TargetReport> reports_;
};

void tell(std::size_t frames, const devices::IgtlTrackingHostReport& report, Context& context) {
  context.result["frames"] = frames;
  context.result["told"] = report.told;
  context.result["dropped"] = report.dropped;
  context.result["callers"] = report.callers;
  context.result["turned_away"] = report.turned_away;
  if (!context.json)
    std::cout << frames << " frames, " << report.callers << " clients, " << report.told << " frames told, "
              << report.dropped << " dropped for slow clients\n";
}

void serveTracking(const Wish& wish, Context& context) {
  if (!wish.isLive() && wish.targets.empty()) throw InputRefused("--target: is wanted for what is recorded");
  auto targets = readTargets(wish.targets);
  checkNames(targets);
  const auto source = wish.isLive() ? openBenchPoints(wish.seed, wish.input.method) : openPoints(wish.input);
  const auto host = IgtlTrackingHost::open(wish.host);
  if (!host) throw CommandFailed(host.error());
  if (targets.empty()) targets.push_back(taughtFrom(*source, "forearm"));
  catchInterrupt();
  std::cerr << "serving " << targets.size() << " targets on port " << (*host)->port() << "\n";
  const std::size_t frames = Service(*source, targets, wish, **host).run();
  tell(frames, (*host)->report(), context);
}

}  // namespace

void addServeTracking(CLI::App& serve, Context& context) {
  CLI::App* command = addCommand(
      serve, context, "tracking",
      "Tell the poses of targets over OpenIGTLink, as the simulated bench sees them or a recording",
      "mirrorarm-cli serve tracking recording --target forearm.yaml --allow 10.0.0.1 --address "
      "10.0.0.2");
  const auto wish = std::make_shared<Wish>();
  addPointInput(*command, wish->input, Inputs::kAtMostOne);
  command->add_option("--target", wish->targets,
                      "Taught target, once for each; the bench's forearm is learnt first without");
  command->add_option("--address", wish->host.address, "Own address to listen at")->capture_default_str();
  command->add_option("--port", wish->host.port, "Own port")->capture_default_str();
  command->add_option("--allow", wish->host.allowed, "Hosts that may connect")->capture_default_str();
  command->add_option("--seconds", wish->seconds, "How long; 0 to the end, or until interrupted")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command->add_option("--seed", wish->seed, "Of the simulated bench")->capture_default_str();
  addTrackerOption(*command, wish->tracker);
  command->callback([wish, &context] { serveTracking(*wish, context); });
}

}  // namespace mirrorarm::cli
