#include <array>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "core/robot/trajectory.h"
#include "tests/common/no_heap.h"
#include "tests/robot/arms.h"

namespace mirrorarm::robot {
namespace {

TimePoint after(double seconds) { return TimePoint(std::chrono::hours(1)) + toClock(Seconds(seconds)); }

MotionState restAt(const Joints& q) { return {q, Joints::Zero(q.size()), Joints::Zero(q.size())}; }

MotionLimits therapy() { return *limitsOf("therapy", testing::lbr()); }

Joints random(std::mt19937& generator, double size) {
  std::uniform_real_distribution<double> any(-size, size);
  return Joints::NullaryExpr(7, [&] { return any(generator); });
}

/// Largest share of speed, acceleration and jerk, by differences on a fine grid.
double worstShare(const Trajectory& motion, const MotionLimits& limits) {
  constexpr double step_s = 0.0005;
  double worst = 0.0;
  MotionState last = motion.at(motion.start());
  for (double t = step_s; t < motion.duration().count() + 0.01; t += step_s) {
    const MotionState now = motion.at(motion.start() + toClock(Seconds(t)));
    const Joints jerk = (now.a_rad_s2 - last.a_rad_s2) / step_s;
    EXPECT_LT((now.q_rad - last.q_rad - 0.5 * step_s * (last.v_rad_s + now.v_rad_s)).cwiseAbs().maxCoeff(),
              1e-8)
        << "a jump";
    worst = std::max({worst, (now.v_rad_s.array().abs() / limits.max_speed_rad_s.array()).maxCoeff(),
                      (now.a_rad_s2.array().abs() / limits.max_acceleration_rad_s2.array()).maxCoeff(),
                      (jerk.array().abs() / limits.max_jerk_rad_s3.array()).maxCoeff()});
    last = now;
  }
  return worst;
}

}  // namespace

TEST(Pursuit, ReachesARestingGoalWithinTheLimits) {
  const MotionLimits limits = therapy();
  std::mt19937 generator(1);
  for (const double size : {0.0, 1e-6, 0.001, 0.02, 0.3})
    for (const double catch_up : {0.0, 0.1}) {
      const Joints goal = testing::working() + random(generator, size);
      const Trajectory motion = Trajectory::pursuit(restAt(testing::working()), {goal, Joints::Zero(7)},
                                                    after(0), limits, {.catch_up = Seconds(catch_up)});
      EXPECT_LT((motion.goal() - goal).cwiseAbs().maxCoeff(), 1e-9) << size;
      EXPECT_LE(worstShare(motion, limits), 1.001) << size;
    }
}

TEST(Pursuit, MeetsAMovingGoalAndAccompaniesIt) {
  const MotionLimits limits = therapy();
  std::mt19937 generator(2);
  for (int i = 0; i < 50; ++i) {
    const MovingGoal goal{testing::working() + random(generator, 0.01), random(generator, 0.1)};
    const PursuitTimes times{.horizon = Seconds(2.0)};
    const Trajectory motion = Trajectory::pursuit(restAt(testing::working()), goal, after(0), limits, times);
    const Joints there = goal.q_rad + 1.5 * goal.v_rad_s;
    const MotionState met = motion.at(after(1.5));
    EXPECT_LT((met.q_rad - there).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_LT((met.v_rad_s - goal.v_rad_s).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_LE(worstShare(motion, limits), 1.001);
    EXPECT_GT(motion.duration(), Seconds(2.0));
    EXPECT_LT(motion.duration(), Seconds(2.5)) << "it rests soon after the horizon";
    EXPECT_EQ(motion.at(motion.end() + std::chrono::seconds(1)).v_rad_s.norm(), 0.0);
  }
}

TEST(Pursuit, PlannedAgainAndAgainItStaysSmooth) {
  const MotionLimits limits = therapy();
  std::mt19937 generator(3);
  MotionState state = restAt(testing::working());
  for (int i = 0; i < 400; ++i) {
    const MovingGoal goal{testing::working() + random(generator, 0.05), random(generator, 0.3)};
    const Trajectory motion =
        Trajectory::pursuit(state, goal, after(0.04 * i), limits, {.catch_up = Seconds(0.08)});
    ASSERT_LE(worstShare(motion, limits), 1.001) << i;
    state = motion.at(after(0.04 * (i + 1)));
  }
}

TEST(Pursuit, AGoalThatLeavesTheRangeIsNotFollowedThere) {
  const MotionLimits limits = therapy();
  MovingGoal goal{testing::working(), Joints::Zero(7)};
  goal.q_rad[0] = limits.upper_rad[0] - 0.01;
  goal.v_rad_s[0] = 0.2;
  const Trajectory motion =
      Trajectory::pursuit(restAt(goal.q_rad - 0.005 * Joints::Unit(7, 0)), goal, after(0), limits);
  for (double t = 0.0; t < 2.0; t += 0.01) EXPECT_LE(motion.at(after(t)).q_rad[0], limits.upper_rad[0]);
}

TEST(Pursuit, WithoutAHorizonItComesToRest) {
  const Joints q = testing::working();
  const MovingGoal goal{q + Joints::Constant(7, 0.01), Joints::Constant(7, 0.1)};
  const Trajectory motion =
      Trajectory::pursuit(restAt(q), goal, after(0), therapy(), {.catch_up = {}, .horizon = {}});
  EXPECT_EQ(motion.at(after(0)).q_rad, q);
  EXPECT_EQ(motion.at(after(1)).q_rad, q);
  EXPECT_TRUE(motion.at(after(1)).v_rad_s.isZero(0.0));
}

TEST(Pursuit, ANumberThatIsNoneStaysInItsJoint) {
  for (std::size_t which = 0; which < 5; ++which) {
    MotionState from = restAt(testing::working());
    MovingGoal goal{from.q_rad, Joints::Constant(7, 0.1)};
    const std::array<Joints*, 5> inputs{&from.q_rad, &from.v_rad_s, &from.a_rad_s2, &goal.q_rad,
                                        &goal.v_rad_s};
    (*inputs[which])[3] = std::numeric_limits<double>::quiet_NaN();
    const Trajectory motion = Trajectory::pursuit(from, goal, after(0), therapy());
    for (double t = 0.0; t < 0.3; t += 0.01) {
      EXPECT_TRUE(motion.at(after(t)).q_rad.head(3).allFinite()) << which << " at " << t;
      EXPECT_TRUE(motion.at(after(t)).q_rad.tail(3).allFinite()) << which << " at " << t;
    }
  }
}

TEST(Pursuit, SmallDistancesAreCaughtUpWithEvenly) {
  const MotionLimits limits = therapy();
  const MovingGoal goal{testing::working() + Joints::Constant(7, 3e-5), Joints::Zero(7)};
  const auto hardest = [&](double catch_up) {
    const Trajectory motion = Trajectory::pursuit(restAt(testing::working()), goal, after(0), limits,
                                                  {.catch_up = Seconds(catch_up)});
    double a = 0.0;
    for (double t = 0.0; t < 0.2; t += 0.001)
      a = std::max(a, motion.at(after(t)).a_rad_s2.cwiseAbs().maxCoeff());
    return a;
  };
  EXPECT_LT(hardest(0.1), 0.1 * hardest(0.0));
}

TEST(Pursuit, PlanningTakesNoHeap) {
  const MotionLimits limits = therapy();
  const MotionState start = restAt(testing::working());
  const MovingGoal goal{testing::working() + Joints::Constant(7, 0.03), Joints::Constant(7, 0.05)};
  const auto taken = mirrorarm::testing::heapCallsIn([&] {
    const Trajectory motion = Trajectory::pursuit(start, goal, after(0), limits);
    static_cast<void>(motion.at(after(0.1)));
  });
  EXPECT_EQ(taken, 0U);
}

}  // namespace mirrorarm::robot
