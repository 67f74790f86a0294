#include <gtest/gtest.h>

#include "core/robot/trajectory.h"
#include "tests/common/no_heap.h"
#include "tests/robot/arms.h"

namespace mirrorarm::robot {
namespace {

constexpr double kCycle_s = 0.005, kReplan_s = 0.040;

TimePoint after(double seconds) { return TimePoint(std::chrono::hours(1)) + toClock(Seconds(seconds)); }

MotionState restAt(const Joints& q) { return {q, Joints::Zero(q.size()), Joints::Zero(q.size())}; }

MotionLimits therapy() { return *limitsOf("therapy", testing::lbr()); }

/// The largest speed, acceleration and jerk as shares of their limits, sampled.
struct Peaks {
  double speed = 0.0, acceleration = 0.0, jerk = 0.0;
};

Peaks peaksOf(const Trajectory& trajectory, const MotionLimits& limits) {
  Peaks peaks;
  constexpr int samples = 4000;
  Joints last = trajectory.at(trajectory.start()).a_rad_s2;
  for (int i = 0; i <= samples; ++i) {
    const MotionState s =
        trajectory.at(trajectory.start() + toClock(trajectory.duration() * (double(i) / samples)));
    const Joints jerk = (s.a_rad_s2 - last) / (trajectory.duration().count() / samples);
    last = s.a_rad_s2;
    peaks.jerk = std::max(peaks.jerk, (jerk.array().abs() / limits.max_jerk_rad_s3.array()).maxCoeff());
    peaks.speed =
        std::max(peaks.speed, (s.v_rad_s.array().abs() / limits.max_speed_rad_s.array()).maxCoeff());
    peaks.acceleration = std::max(
        peaks.acceleration, (s.a_rad_s2.array().abs() / limits.max_acceleration_rad_s2.array()).maxCoeff());
  }
  return peaks;
}

Joints random(std::mt19937& generator, double size) {
  std::uniform_real_distribution<double> any(-size, size);
  Joints q(7);
  for (double& angle : q) angle = any(generator);
  return q;
}

}  // namespace

TEST(Trajectory, RestStaysWhereItIs) {
  const Trajectory trajectory = Trajectory::rest(testing::working(), after(1));
  EXPECT_TRUE(trajectory.valid());
  EXPECT_FALSE(Trajectory().valid());
  for (double t : {0.0, 1.0, 9.0}) {
    EXPECT_EQ(trajectory.at(after(t)).q_rad, testing::working());
    EXPECT_EQ(trajectory.at(after(t)).v_rad_s.norm(), 0.0);
  }
  EXPECT_EQ(trajectory.goal(), testing::working());
}

TEST(Trajectory, FromRestOneLimitIsUsedUpAndNoneBroken) {
  const MotionLimits limits = therapy();
  std::mt19937 generator(1);
  for (double size : {0.001, 0.02, 0.1, 0.3, 1.0}) {
    const Joints from = testing::working(), to = from + random(generator, size);
    const Trajectory trajectory = Trajectory::quintic(restAt(from), to, after(0), limits);
    const Peaks peaks = peaksOf(trajectory, limits);
    EXPECT_LE(peaks.speed, 1.0 + 1e-9);
    EXPECT_LE(peaks.acceleration, 1.0 + 1e-9);
    EXPECT_LE(peaks.jerk, 1.0 + 1e-9);
    EXPECT_GT(std::max({peaks.speed, peaks.acceleration, peaks.jerk}), 0.995);
    EXPECT_LT((trajectory.at(trajectory.end()).q_rad - to).norm(), 1e-9);
    EXPECT_LT((trajectory.at(after(100)).q_rad - to).norm(), 1e-12);
    EXPECT_EQ(trajectory.at(after(100)).v_rad_s.norm(), 0.0);
  }
}

TEST(Trajectory, MovingStartIsContinuousAndKeepsTheLimits) {
  const MotionLimits limits = therapy();
  std::mt19937 generator(2);
  int within = 0;
  constexpr int rounds = 300;
  for (int i = 0; i < rounds; ++i) {
    const MotionState from{testing::working(), random(generator, 0.15), random(generator, 0.2)};
    const Trajectory trajectory =
        Trajectory::quintic(from, from.q_rad + random(generator, 0.3), after(0), limits);
    const MotionState first = trajectory.at(after(0));
    ASSERT_LT((first.q_rad - from.q_rad).norm() + (first.v_rad_s - from.v_rad_s).norm() +
                  (first.a_rad_s2 - from.a_rad_s2).norm(),
              1e-12);
    const Peaks peaks = peaksOf(trajectory, limits);
    if (peaks.speed <= 1.0 + 1e-6 && peaks.acceleration <= 1.0 + 1e-6) ++within;
    ASSERT_LT(std::max(peaks.speed, peaks.acceleration), 1.5);
  }
  EXPECT_GE(within, rounds * 95 / 100);
}

TEST(Trajectory, StartTooFastForTheLimitsStillEndsAtTheGoal) {
  const MotionLimits limits = therapy();
  const Joints goal = testing::working();
  MotionState from = restAt(goal);
  from.v_rad_s.setConstant(0.5);
  const Trajectory trajectory = Trajectory::quintic(from, goal, after(0), limits);
  EXPECT_LT((trajectory.goal() - goal).norm(), 1e-9);
  EXPECT_LT(trajectory.duration().count(), 15.0);
}

TEST(Trajectory, ExcursionStaysInTheJointRange) {
  const MotionLimits limits = therapy();
  MotionState from = restAt(testing::working());
  from.q_rad[3] = limits.upper_rad[3] - 0.08;
  from.v_rad_s[3] = 0.2;
  Joints goal = from.q_rad;
  goal[3] = limits.upper_rad[3] - 0.001;
  const Trajectory trajectory = Trajectory::quintic(from, goal, after(0), limits);
  for (double t = 0.0; t < trajectory.duration().count(); t += 0.005)
    EXPECT_LE(trajectory.at(after(t)).q_rad[3], limits.upper_rad[3] + 1e-6);
}

TEST(Trajectory, NotFasterThanAsked) {
  Joints goal = testing::working();
  goal[0] += 0.01;
  const Trajectory trajectory =
      Trajectory::quintic(restAt(testing::working()), goal, after(0), therapy(), Seconds(2.0));
  EXPECT_NEAR(trajectory.duration().count(), 2.0, 1e-9);
}

TEST(Trajectory, DetourIsContinuousWithinLimitsAndDoesNotRestOnTheWay) {
  const MotionLimits limits = therapy();
  const Joints start = testing::working();
  std::vector<Joints> waypoints;
  for (const double way : {0.1, 0.25, 0.4}) {
    waypoints.push_back(start);
    waypoints.back()[0] += way;
    waypoints.back()[1] += way == 0.25 ? 0.2 : 0.0;
  }
  const Trajectory trajectory = Trajectory::through(restAt(start), waypoints, after(0), limits);
  const Peaks peaks = peaksOf(trajectory, limits);
  EXPECT_LE(peaks.speed, 1.0 + 1e-6);
  EXPECT_LE(peaks.acceleration, 1.0 + 1e-6);
  MotionState last = trajectory.at(after(0));
  double slowest_midway = 1.0;
  for (double t = 0.001; t < trajectory.duration().count(); t += 0.001) {
    const MotionState state = trajectory.at(after(t));
    ASSERT_LT((state.q_rad - last.q_rad).norm(), 0.001);
    ASSERT_LT((state.v_rad_s - last.v_rad_s).norm(), 0.005);
    ASSERT_LT((state.a_rad_s2 - last.a_rad_s2).norm(), 0.05);
    if (std::abs(state.q_rad[0] - start[0] - 0.2) < 0.12)
      slowest_midway = std::min(slowest_midway, state.v_rad_s[0]);
    last = state;
  }
  EXPECT_GT(slowest_midway, 0.01);
}

TEST(Trajectory, RetargetingAFixedGoalReachesItOnTime) {
  const MotionLimits limits = therapy();
  Joints goal = testing::working();
  goal[0] += 0.2;
  const Trajectory direct = Trajectory::quintic(restAt(testing::working()), goal, after(0), limits);
  Trajectory trajectory = direct;
  for (double t = 0.0; t < direct.duration().count() + 0.1; t += kReplan_s) {
    EXPECT_LT((trajectory.at(after(t)).q_rad - direct.at(after(t)).q_rad).norm(), 2e-3) << t;
    trajectory = Trajectory::quintic(trajectory.at(after(t)), goal, after(t), limits);
  }
  EXPECT_LT((trajectory.at(after(direct.duration().count() + 0.2)).q_rad - goal).norm(), 1e-6);
}

TEST(Trajectory, RetargetingAMovingGoalFollowsWithoutOscillation) {
  const MotionLimits limits = therapy();
  constexpr double goal_speed = 0.08, goal_stops_at = 4.0;
  Trajectory trajectory = Trajectory::rest(testing::working(), after(0));
  double largest_lag = 0.0, slowest = 1.0, fastest = 0.0, overshoot = 0.0;
  for (double t = 0.0; t < 6.0; t += kReplan_s) {
    Joints goal = testing::working();
    goal[0] += goal_speed * std::min(t, goal_stops_at);
    trajectory = Trajectory::quintic(trajectory.at(after(t)), goal, after(t), limits);
    for (double s = t; s < t + kReplan_s; s += kCycle_s) {
      const MotionState state = trajectory.at(after(s));
      overshoot = std::max(overshoot, state.q_rad[0] - testing::working()[0] - goal_speed * goal_stops_at);
      if (s < 2.0 || s > goal_stops_at) continue;
      largest_lag = std::max(largest_lag, goal[0] - state.q_rad[0]);
      slowest = std::min(slowest, state.v_rad_s[0]);
      fastest = std::max(fastest, state.v_rad_s[0]);
    }
  }
  EXPECT_LT(largest_lag / goal_speed, 0.25);
  EXPECT_GT(slowest, 0.95 * goal_speed);
  EXPECT_LT(fastest, 1.05 * goal_speed);
  EXPECT_LT(overshoot, 1e-5);
}

TEST(Trajectory, SamplingDoesNotAllocate) {
  if (!::mirrorarm::testing::heapIsCounted) GTEST_SKIP() << "a sanitizer owns the heap";
  const Trajectory trajectory = Trajectory::rest(testing::working(), after(0));
  double sum = 0.0;
  EXPECT_EQ(::mirrorarm::testing::heapCallsIn([&] { sum += trajectory.at(after(1)).q_rad[0]; }), 0U) << sum;
}

}  // namespace mirrorarm::robot
