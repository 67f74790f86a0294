#include <array>
#include <atomic>
#include <cmath>
#include <optional>
#include <random>
#include <stdexcept>
#include <thread>

#include "benchmarks/robot/bench_arm.h"
#include "benchmarks/robot/suite.h"
#include "benchmarks/statistics.h"
#include "benchmarks/timing.h"
#include "core/common/time_source.h"
#include "core/control/servo_loop.h"
#include "core/simulation/simulated_robot.h"

namespace mirrorarm::benchmarks::robot {
namespace {

using namespace mirrorarm::robot;
using control::ServoLoop;
using control::ServoState;
using control::StopReason;

constexpr double kPeriod_s = 0.001;
constexpr double kToolSpeed_m_s = 0.235;  // what the guard lets come of 0.24
constexpr double kFullHelp_m = 0.1;       // a joint that moves the flange so much goes at its full speed
constexpr double kRest_m_s = 0.001;
constexpr double kGoal_s = 0.32, kGoal_m = 0.040;
constexpr std::array<std::array<double, 7>, 4> kPostures = {{{0.0, -0.6, 0.0, 1.4, 0.0, 1.0, 0.0},
                                                             {0.8, -0.9, 0.4, 1.0, -0.5, 0.8, 0.3},
                                                             {-0.5, -0.3, -0.6, 1.8, 0.9, -0.7, 0.0},
                                                             {0.0, -1.4, 0.0, 0.4, 0.0, 0.6, 0.0}}};

/// A servo loop on the simulated robot with its drives; time passes when it is told to.
class Rig {
 public:
  explicit Rig(const Joints& start)
      : robot_(arm_, start, time_, {.seed = kSeed}), servo_(arm_, limits_, robot_, {}, {}, keepClear()) {
    time_.set(now_);
    run(0.05);
  }

  const ServoState& cycle() {
    now_ += toClock(Seconds(kPeriod_s));
    time_.set(now_);
    servo_.setTracking({now_, now_, false});
    const TimePoint before = Clock::now();
    state_ = servo_.step(now_);
    step_us_.push_back(1e6 * secondsBetween(before, Clock::now()));
    return state_;
  }
  void run(double seconds) {
    for (double t = 0.0; t < seconds; t += kPeriod_s) cycle();
  }
  void setOut(const Joints& goal) {
    servo_.setTrajectory(Trajectory::quintic(state_.commanded, goal, state_.time, limits_));
  }
  void stop() { servo_.stop(StopReason::kOperator); }

  [[nodiscard]] const ServoState& state() const { return state_; }
  [[nodiscard]] const MotionLimits& limits() const { return limits_; }
  [[nodiscard]] const Kinematics& kinematics() const { return kinematics_; }
  [[nodiscard]] const std::vector<double>& stepTimes_us() const { return step_us_; }
  /// Where the drives have brought the flange.
  [[nodiscard]] Eigen::Vector3d flange() const {
    return kinematics_.flange(robot_.jointsAt(now_)).translation();
  }

 private:
  [[nodiscard]] Clearance keepClear() const { return {arm_, handOn(arm_), {}}; }

  ArmDescription arm_ = lbr();
  MotionLimits limits_ = *limitsOf("therapy", arm_);
  Kinematics kinematics_{arm_};
  ManualTime time_;
  TimePoint now_{std::chrono::hours(1)};
  simulation::SimulatedRobot robot_;
  ServoLoop servo_;
  ServoState state_;
  std::vector<double> step_us_;
};

/// Joint motion in which every joint does what it can to bring the flange along `direction_B`.
Joints goalAlong(const Rig& rig, const Joints& start, const Eigen::Vector3d& direction_B) {
  const Jacobian J = rig.kinematics().jacobian(start);
  const Joints helped = J.topRows<3>().transpose() * direction_B;
  return start + 0.5 * (helped / kFullHelp_m).cwiseMax(-1.0).cwiseMin(1.0);
}

struct Stopped {
  double time_s = 0.0;
  double way_m = 0.0;
};

/// From the cycle in which the stop is called to the flange's rest, as the drives move it. Nothing where the
/// joints' own limits do not let the flange reach the speed.
std::optional<Stopped> stopFrom(const Joints& start, const Eigen::Vector3d& direction_B,
                                std::vector<double>& step_us) {
  Rig rig(start);
  rig.setOut(goalAlong(rig, start, direction_B));
  Eigen::Vector3d before = rig.flange();
  double speed = 0.0;
  for (int i = 0; i < 4000 && speed < kToolSpeed_m_s; ++i) {
    rig.cycle();
    speed = (rig.flange() - before).norm() / kPeriod_s;
    before = rig.flange();
  }
  if (speed < kToolSpeed_m_s) return std::nullopt;
  rig.stop();
  Stopped stopped;
  for (int i = 1; i < 2000 && speed > kRest_m_s; ++i) {
    rig.cycle();
    speed = (rig.flange() - before).norm() / kPeriod_s;
    stopped.way_m += speed * kPeriod_s;
    stopped.time_s = i * kPeriod_s;
    before = rig.flange();
  }
  step_us.insert(step_us.end(), rig.stepTimes_us().begin(), rig.stepTimes_us().end());
  return stopped;
}

/// A servo loop on the machine's own clock, in a thread of its own.
class LiveServo {
 public:
  LiveServo()
      : robot_(arm_, start(), time_, {.seed = kSeed}), servo_(arm_, *limitsOf("therapy", arm_), robot_, {}) {}

  /// Cycles from a press in another thread to the first that brakes.
  long pressed() {
    const long at = cycle_.load();
    stopped_at_ = -1;
    servo_.stop(StopReason::kOperator);
    while (stopped_at_.load() < 0) std::this_thread::yield();
    return stopped_at_.load() - at;
  }
  void reset() {
    servo_.resetStop();
    while (latched_.load()) std::this_thread::yield();
  }

 private:
  static Joints start() { return Eigen::Map<const Eigen::Matrix<double, 7, 1>>(kPostures[0].data()); }
  void work(const std::stop_token& done) {
    TimePoint next = Clock::now();
    while (!done.stop_requested()) {
      next += toClock(Seconds(kPeriod_s));
      std::this_thread::sleep_until(next);
      const long cycle = ++cycle_;
      const ServoState& state = servo_.step(Clock::now());
      latched_ = state.stop != StopReason::kNone;
      if (state.permit == control::Permit::kStop && stopped_at_.load() < 0) stopped_at_ = cycle;
      while (servo_.takeState()) continue;
    }
  }

  SteadyTime time_;
  ArmDescription arm_ = lbr();
  simulation::SimulatedRobot robot_;
  ServoLoop servo_;
  std::atomic<long> cycle_{0}, stopped_at_{0};
  std::atomic<bool> latched_{false};
  std::jthread thread_{[this](const std::stop_token& done) { work(done); }};
};

/// Stops from a thread of their own while this one, as a screen that hangs, does nothing at all.
std::vector<double> stopsWhileTheScreenHangs(int stops) {
  std::vector<double> cycles;
  std::jthread pedal([&] {
    LiveServo servo;
    for (int i = 0; i < stops; ++i) {
      std::this_thread::sleep_for(std::chrono::microseconds(20'300 + 137 * (i % 10)));
      cycles.push_back(static_cast<double>(servo.pressed()));
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
      servo.reset();
    }
  });
  pedal.join();
  return cycles;
}

}  // namespace

void measureStop(Run& run) {
  std::vector<double> times_s, ways_m, step_us;
  for (const auto& posture : kPostures)
    for (int axis = 0; axis < 6; ++axis) {
      const Joints start = Eigen::Map<const Eigen::Matrix<double, 7, 1>>(posture.data());
      const Eigen::Vector3d direction = (axis < 3 ? 1.0 : -1.0) * Eigen::Vector3d::Unit(axis % 3);
      const auto stopped = stopFrom(start, direction, step_us);
      if (!stopped) continue;
      times_s.push_back(stopped->time_s);
      ways_m.push_back(stopped->way_m);
      if (run.options.quick) break;
    }
  if (times_s.empty()) throw std::runtime_error("no posture reaches the speed to stop from");
  const double worst_s = quantile(times_s, 1.0), worst_m = quantile(ways_m, 1.0);
  run.report.rows.push_back({"",
                             "stop from 0.24 m/s, drives included",
                             "<= 0.32 s and <= 40 mm",
                             {{"worst time", worst_s, "s"}, {"worst way", 1e3 * worst_m, "mm"}},
                             {{"median time", quantile(times_s, 0.5), "s"},
                              {"median way", 1e3 * quantile(ways_m, 0.5), "mm"},
                              {"stops", static_cast<double>(times_s.size()), ""}},
                             worst_s <= kGoal_s && worst_m <= kGoal_m});
  run.report.rows.push_back(
      {"",
       "a whole servo step",
       "<= 100 us median",
       {{"median", quantile(step_us, 0.5), "us"}, {"p99", quantile(step_us, 0.99), "us"}},
       {},
       quantile(step_us, 0.5) <= 100.0});
  const auto cycles = stopsWhileTheScreenHangs(run.trials(200, 10));
  run.report.rows.push_back(
      {"",
       "from a stop in any thread to the first command that brakes, the screen hanging",
       "<= 1 cycle",
       {{"worst", quantile(cycles, 1.0), "cycles"}, {"median", quantile(cycles, 0.5), ""}},
       {},
       quantile(cycles, 1.0) <= 1.0});
}

}  // namespace mirrorarm::benchmarks::robot
