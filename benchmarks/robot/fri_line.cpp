#include "benchmarks/robot/fri_line.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <stdexcept>
#include <thread>

#include "benchmarks/robot/bench_arm.h"
#include "benchmarks/robot/pause_witness.h"
#include "core/control/servo_loop.h"

namespace mirrorarm::benchmarks::robot {
namespace {

using mirrorarm::robot::ArmDescription;
using mirrorarm::robot::Joints;
using mirrorarm::robot::Trajectory;

constexpr double kPeriod_us = 1000.0;
constexpr double kTooLong_us = 0.5 * kPeriod_us;
constexpr Clock::duration kBefore = std::chrono::milliseconds(4), kAfter = std::chrono::milliseconds(1);
constexpr double kSwing_rad = 0.15;
constexpr double kSilentCycles = 3.0;
constexpr int kResetAfter = 500;  // cycles of rest
const Joints kHome = (Joints(7) << 0.0, 0.6, 0.0, -1.0, 0.0, 0.9, 0.0).finished();

template <class T>
T orThrow(Expected<T, std::string> value) {
  if (!value) throw std::runtime_error(value.error());
  return std::move(*value);
}

double processorTime_us() {
  timespec time{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e6 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_nsec);
}

/// What our thread did with one of the controller's datagrams.
struct Handled {
  std::uint64_t number = 0;  ///< of the datagram, counted through all wraps
  TimePoint at{};            ///< when it was done
  double computing_us = 0.0;
  bool answered = false;
};

/// Our side: the servo loop on the link, swinging to and fro, as the station's servo thread runs it.
class ServoSide {
 public:
  ServoSide(devices::FriLink& link, const FriRunOrder& order)
      : order_(order),
        arm_(lbr()),
        limits_(*mirrorarm::robot::limitsOf("therapy", arm_)),
        link_(link),
        loop_(arm_, limits_, link, {}) {
    const auto cycles = static_cast<std::size_t>(1.2 * order.duration.count() / link.period().count());
    handled.reserve(cycles);
    run.answer_delay_us.reserve(cycles);
    run.computing_us.reserve(cycles);
  }

  void serve(const std::stop_token& stop) {
    const auto grant = devices::askForRealTime();
    run.real_time = schedulingLine(grant) + "; " + memoryLine(grant);
    while (!stop.stop_requested()) {
      const double before_us = processorTime_us();
      link_.awaitCycle(kSilentCycles * link_.period());
      const auto& state = loop_.step(Clock::now());
      const double computing_us = processorTime_us() - before_us;
      note(computing_us);
      lead(state);
    }
    run.driving = seen_.phase == devices::FriPhase::kCommanding;
    run.fall = seen_.fall;
    link_.halt();
  }

  std::vector<Handled> handled;
  FriRun run;

 private:
  /// What is told in a cycle was so before its own answer: that of the cycle before is judged now.
  void note(double computing_us) {
    const auto seen = link_.takeStatistics().value_or(seen_);
    if (!handled.empty()) handled.back().answered = seen.answered > seen_.answered;
    if (seen.answered > seen_.answered) run.answer_delay_us.push_back(1e6 * seen.answer_delay.count());
    run.computing_us.push_back(computing_us);
    const auto step = static_cast<std::uint16_t>(seen.newest_sequence - seen_.newest_sequence);
    number_ += step;
    if (step > 0) handled.push_back({number_, Clock::now(), computing_us, false});
    seen_ = seen;
  }

  /// What the control thread and the operator do.
  void lead(const control::ServoState& state) {
    const Joints& q = state.measured.q_rad;
    if (q.size() == 0) return;
    if (state.stop != stop_) noteStop(state);
    stop_ = state.stop;
    if (stop_ != control::StopReason::kNone) {
      rested_ = state.at_rest ? rested_ + 1 : 0;
      if (rested_ == 1 && run.rest_s == 0.0) {
        run.rest_s = secondsBetween(stopped_at_, Clock::now());
        rest_ = q;
      }
      if (rested_ > 0 && rest_.size() > 0 && !order_.resume)
        run.creep_rad = std::max(run.creep_rad, (q - rest_).cwiseAbs().maxCoeff());
      if (order_.resume && rested_ > kResetAfter) {
        loop_.resetStop();
        rested_ = 0;
      }
      goal_end_ = {};
      return;
    }
    swing(state);
  }

  void noteStop(const control::ServoState& state) {
    if (state.stop == control::StopReason::kNone) return;
    run.stops.push_back(state.stop);
    stopped_at_ = Clock::now();
    if (run.stops.size() == 1) run.first_stop_s = secondsBetween(begun_at_, stopped_at_);
    rested_ = 0;
  }

  void swing(const control::ServoState& state) {
    if (seen_.phase != devices::FriPhase::kCommanding || state.time < goal_end_) return;
    if (begin_.size() == 0) begin_ = state.measured.q_rad;
    away_ = !away_;
    const Joints goal = away_ ? Joints(begin_.array() + kSwing_rad) : begin_;
    const auto motion = Trajectory::quintic(state.commanded, goal, state.time, limits_);
    loop_.setTrajectory(motion);
    goal_end_ = motion.end() + std::chrono::milliseconds(100);
    run.travelled_rad += kSwing_rad;
  }

  const FriRunOrder& order_;
  ArmDescription arm_;
  mirrorarm::robot::MotionLimits limits_;
  devices::FriLink& link_;
  control::ServoLoop loop_;
  devices::FriLinkStatistics seen_;
  std::uint64_t number_ = 0;
  control::StopReason stop_ = control::StopReason::kNone;
  const TimePoint begun_at_ = Clock::now();
  TimePoint stopped_at_{}, goal_end_{};
  int rested_ = 0;
  Joints begin_, rest_;
  bool away_ = false;
};

/// Whether our thread computed for long while every core was ours. (The processor time of a thread also
/// counts what the hypervisor takes away meanwhile.)
bool computedLong(const Handled& cycle, const PauseWitness& witness) {
  return cycle.computing_us > kTooLong_us && !witness.sawPause(cycle.at - kBefore, cycle.at + kAfter);
}

/// Whose fault each missed answer is.
MissedAnswers attribute(const std::vector<std::uint64_t>& missed, const std::vector<Handled>& handled,
                        const PauseWitness& witness) {
  MissedAnswers result;
  for (const std::uint64_t number : missed) {
    const auto at = std::lower_bound(handled.begin(), handled.end(), number,
                                     [](const Handled& each, std::uint64_t n) { return each.number < n; });
    // Where it was overtaken by later ones, or the cycle before was still busy, those count.
    if (at != handled.end() && at->number == number && !at->answered)
      ++result.unanswered;
    else if ((at != handled.end() && computedLong(*at, witness)) ||
             (at != handled.begin() && computedLong(*std::prev(at), witness)))
      ++result.computed;
    else
      ++result.machine;
  }
  return result;
}

}  // namespace

FriRun runFriLine(const FriRunOrder& order) {
  const auto link = orThrow(devices::FriLink::open({.port = 0, .controller = "127.0.0.1"}));
  const auto controller = orThrow(peers::FriControllerHost::open(
      {.port = link->port(), .faults = order.faults, .seed = order.seed}, lbr(), kHome));
  ServoSide side(*link, order);
  PauseWitness witness(order.duration);
  {
    std::jthread servo([&](const std::stop_token& stop) { side.serve(stop); });
    std::jthread robot([&](const std::stop_token& stop) {
      static_cast<void>(devices::askForRealTime(devices::kServoPriority + 1));
      controller->run(stop, order.duration);
    });
    robot.join();
    servo.request_stop();
    servo.join();
  }
  witness.end();
  FriRun run = std::move(side.run);
  const auto& report = controller->controller().report();
  run.cycles = report.cycles;
  run.missed = attribute(report.missed_cycles, side.handled, witness);
  run.skipped_beats = controller->skippedBeats();
  run.pauses_us = witness.lateness_us();
  return run;
}

}  // namespace mirrorarm::benchmarks::robot
