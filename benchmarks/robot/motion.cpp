#include <cmath>
#include <random>
#include <vector>

#include "benchmarks/robot/suite.h"
#include "benchmarks/timing.h"
#include "core/robot/trajectory.h"

namespace mirrorarm::benchmarks::robot {
namespace {

using mirrorarm::robot::Joints;
using mirrorarm::robot::MotionLimits;
using mirrorarm::robot::MotionState;
using mirrorarm::robot::MovingGoal;
using mirrorarm::robot::PursuitTimes;
using mirrorarm::robot::Trajectory;

constexpr int kJoints = 7;
constexpr double kFrame_s = 1.0 / 24.0;
constexpr double kMicroseconds = 1000.0;  // of a millisecond

/// The therapy profile of a seven-joint arm.
MotionLimits therapyLimits() {
  MotionLimits limits{Joints::Constant(kJoints, -2.9),
                      Joints::Constant(kJoints, 2.9),
                      Joints::Constant(kJoints, 0.24),
                      Joints::Constant(kJoints, 0.8),
                      Joints::Constant(kJoints, 40.0),
                      0.24,
                      0.8};
  limits.max_acceleration_rad_s2.head<2>().setConstant(0.5);
  return limits;
}

/// What the follower is asked while it follows: each time from where the motion before had led after a frame.
struct Question {
  MotionState from;
  MovingGoal goal;
};

std::vector<Question> questions(int count, const MotionLimits& limits) {
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  const auto joints = [&](double size) -> Joints {
    return Joints::NullaryExpr(kJoints, [&] { return size * any(random); });
  };
  std::vector<Question> asked;
  MotionState state{Joints::Zero(kJoints), Joints::Zero(kJoints), Joints::Zero(kJoints)};
  for (int i = 0; i < count; ++i) {
    asked.push_back({state, {joints(0.1), joints(0.1)}});
    const Trajectory motion = Trajectory::pursuit(state, asked.back().goal, TimePoint{}, limits);
    state = motion.at(TimePoint{} + toClock(Seconds(kFrame_s)));
  }
  return asked;
}

std::vector<Figure> figures(const Timing& timing) {
  return {{"median", kMicroseconds * timing.median_ms, "us"}, {"p99", kMicroseconds * timing.p99_ms, "us"}};
}

}  // namespace

void measureMotion(Run& run) {
  const int count = run.trials(50'000, 500);
  const MotionLimits limits = therapyLimits();
  const std::vector<Question> asked = questions(count, limits);
  const auto timeOf = [&](auto plan) {
    return timed(count, [&](int i) { static_cast<void>(plan(asked[static_cast<std::size_t>(i)])); });
  };
  const Timing eager = timeOf(
      [&](const Question& each) { return Trajectory::pursuit(each.from, each.goal, TimePoint{}, limits); });
  const Timing even = timeOf([&](const Question& each) {
    return Trajectory::pursuit(each.from, each.goal, TimePoint{}, limits,
                               {.catch_up = Seconds(2.0 * kFrame_s)});
  });
  const Timing quintic = timeOf([&](const Question& each) {
    return Trajectory::quintic(each.from, each.goal.q_rad, TimePoint{}, limits);
  });
  const Trajectory motion = Trajectory::pursuit(asked[0].from, asked[0].goal, TimePoint{}, limits);
  const Timing sampled = timed(count, [&](int i) {
    static_cast<void>(motion.at(TimePoint{} + toClock(Seconds(1e-5 * (i % 20'000)))));
  });
  run.report.rows.push_back({"", "Onto a moving goal, 7 joints, least time", "<= 20 us median",
                             figures(eager), figures(quintic), eager.median_ms * kMicroseconds <= 20.0});
  run.report.rows.back().references[0].name = "quintic median";
  run.report.rows.back().references[1].name = "quintic p99";
  run.report.rows.push_back(
      {"", "The same, small distances caught up with evenly", "", figures(even), {}, {}});
  run.report.rows.push_back({"", "Asking a motion for its state", "", figures(sampled), {}, {}});
}

}  // namespace mirrorarm::benchmarks::robot
