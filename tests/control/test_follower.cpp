#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "core/control/follower.h"
#include "tests/robot/arms.h"

namespace mirrorarm::control {
namespace {

using robot::Joints;
using robot::MotionState;

constexpr double kStep_s = 0.040;

TimePoint after(double seconds) { return TimePoint(std::chrono::hours(1)) + toClock(Seconds(seconds)); }

MotionState restAt(const Joints& q) { return {q, Joints::Zero(7), Joints::Zero(7)}; }

/// A sling 135 mm before the flange, and a follower that may meet obstacles.
struct Bench {
  explicit Bench(std::span<const robot::Obstacle> obstacles = {}, std::string_view profile = "therapy")
      : limits(*robot::limitsOf(profile, arm)),
        desk(robot::Planner(arm, {}, obstacles, {})),
        follower(arm, X_FE, limits, robot::CollisionWorld(arm, {}, obstacles), {}) {}

  /// A step with a goal that does not move; a question is answered at once.
  FollowStep step(const RigidTransform& X_BE, const MotionState& commanded, TimePoint now) {
    return step(ToolGoal::resting(X_BE), commanded, now);
  }
  FollowStep step(const ToolGoal& goal, const MotionState& commanded, TimePoint now) {
    const FollowStep first = follower.step(goal, commanded, now);
    if (!first.question) return first;
    EXPECT_EQ(first.outcome, FollowOutcome::kPlanning);
    desk.ask(*first.question, now);
    desk.answer();
    return follower.take(*desk.takeAnswer(), commanded, now);
  }

  [[nodiscard]] RigidTransform slingAt(const Joints& q) const { return kinematics.flange(q) * X_FE; }

  robot::ArmDescription arm = robot::testing::lbr();
  RigidTransform X_FE = makeTransform(Eigen::Quaterniond::Identity(), {0.0, 0.0, 0.135});
  robot::MotionLimits limits;
  robot::Kinematics kinematics{arm};
  PlanningDesk desk;
  Follower follower;
};

}  // namespace

TEST(Follower, BringsTheSlingToTheGoal) {
  Bench bench;
  const Joints start = robot::testing::working();
  RigidTransform X_BE = bench.slingAt(start);
  X_BE.translation() += Eigen::Vector3d(0.02, 0.05, -0.03);
  const FollowStep step = bench.step(X_BE, restAt(start), after(0));
  ASSERT_EQ(step.outcome, FollowOutcome::kDirect);
  const RigidTransform X_reached = bench.slingAt(step.trajectory.goal());
  EXPECT_LT((X_reached.translation() - X_BE.translation()).norm(), 2e-4);
  EXPECT_LT(angleBetween(X_reached, X_BE), 2e-4);
}

TEST(Follower, MotionKeepsTheToolLimits) {
  Bench bench({}, "head");
  const Joints start = robot::testing::working();
  const Joints turned = start + 0.8 * Joints::Unit(7, 0);
  const FollowStep step = bench.step(bench.slingAt(turned), restAt(start), after(0));
  ASSERT_TRUE(step.isNew()) << id(step.outcome);
  double fastest = 0.0;
  for (double t = 0.0; t < step.trajectory.duration().count(); t += 0.005) {
    const MotionState state = step.trajectory.at(after(t));
    fastest = std::max(fastest, (bench.kinematics.jacobian(state.q_rad).topRows<3>() * state.v_rad_s).norm());
  }
  EXPECT_LT(fastest, 1.01 * bench.limits.max_tool_speed_m_s);
  EXPECT_GT(fastest, 0.9 * bench.limits.max_tool_speed_m_s);
}

TEST(Follower, NewMotionsBeginWhereTheOldOnesWillBe) {
  Bench bench;
  const Joints start = robot::testing::working();
  RigidTransform X_BE = bench.slingAt(start);
  X_BE.translation().y() += 0.05;
  const FollowStep first = bench.step(X_BE, restAt(start), after(0));
  ASSERT_TRUE(first.isNew());
  EXPECT_GT(first.trajectory.start(), after(0));
  const auto moving = [&](double t) { return first.trajectory.at(after(t)); };
  X_BE.translation().y() += 0.02;
  const FollowStep second = bench.step(X_BE, moving(0.1), after(0.1));
  ASSERT_TRUE(second.isNew());
  const TimePoint begin = second.trajectory.start();
  EXPECT_LT((second.trajectory.at(begin).q_rad - first.trajectory.at(begin).q_rad).norm(), 1e-12);
  EXPECT_LT((second.trajectory.at(begin).a_rad_s2 - first.trajectory.at(begin).a_rad_s2).norm(), 1e-9);
  EXPECT_EQ(bench.step(X_BE, restAt(start), after(2.0)).outcome, FollowOutcome::kDirect)
      << "a robot that did not follow is led again";
}

TEST(Follower, MeetsAMovingGoal) {
  Bench bench;
  const Joints start = robot::testing::working();
  const RigidTransform X_start = bench.slingAt(start);
  const auto goalAt = [&](double t) {
    RigidTransform X_BE = X_start;
    X_BE.translation().y() += 0.06 * t;
    return X_BE;
  };
  robot::Trajectory trajectory = robot::Trajectory::rest(start, after(0));
  for (double t = 0.0; t < 1.5; t += kStep_s) {
    const FollowStep step = bench.step({goalAt(t), goalAt(t + 0.02)}, trajectory.at(after(t)), after(t));
    ASSERT_EQ(step.outcome, FollowOutcome::kDirect);
    trajectory = step.trajectory;
  }
  const Joints q = trajectory.at(after(1.5)).q_rad;
  EXPECT_LT((bench.slingAt(q).translation() - goalAt(1.5).translation()).norm(), 1e-3) << "it does not trail";
}

TEST(Follower, RejectsWhatIsOutOfReachOrTooFar) {
  Bench bench;
  const Joints start = robot::testing::working();
  RigidTransform X_BE = bench.slingAt(start);
  X_BE.translation().x() += 2.0;
  EXPECT_EQ(bench.step(X_BE, restAt(start), after(0)).outcome, FollowOutcome::kOutOfReach);
  const Joints turned = start + 1.6 * Joints::Unit(7, 0);
  EXPECT_EQ(bench.step(bench.slingAt(turned), restAt(start), after(0)).outcome, FollowOutcome::kJointRange);
}

TEST(Follower, PlansAroundAWallAndTheMotionStaysClear) {
  Joints from = robot::testing::working(), to = from, middle = from;
  from[0] = -0.4;
  to[0] = 0.4;
  const Eigen::Vector3d flange = Bench().kinematics.flange(middle).translation();
  const std::vector<robot::Obstacle> wall = {
      {makeTransform(Eigen::Quaterniond::Identity(), flange), {0.1, 0.01, 0.1}}};
  Bench bench(wall);
  const FollowStep step = bench.step(bench.slingAt(to), restAt(from), after(0));
  ASSERT_EQ(step.outcome, FollowOutcome::kPlanned) << id(step.outcome);
  const robot::Planner judge(bench.arm, {}, wall, {});
  for (double t = 0.0; t < step.trajectory.duration().count(); t += 0.01)
    ASSERT_FALSE(judge.collides(step.trajectory.at(after(t)).q_rad)) << t;
}

TEST(Follower, GoalInsideAWallIsBlocked) {
  Joints to = robot::testing::working();
  to[0] += 0.3;
  const std::vector<robot::Obstacle> wall = {
      {makeTransform(Eigen::Quaterniond::Identity(), Bench().kinematics.flange(to).translation()),
       {0.1, 0.1, 0.1}}};
  Bench bench(wall);
  const FollowStep step = bench.step(bench.slingAt(to), restAt(robot::testing::working()), after(0));
  EXPECT_EQ(step.outcome, FollowOutcome::kBlocked);
}

TEST(Follower, GoalInsideTheHeadIsBlocked) {
  Joints to = robot::testing::working();
  to[0] += 0.3;
  const std::vector head = {
      robot::ball(robot::ObstacleKind::kHead, Bench().kinematics.flange(to).translation(), 0.12)};
  Bench bench(head);
  EXPECT_EQ(bench.step(bench.slingAt(to), restAt(robot::testing::working()), after(0)).outcome,
            FollowOutcome::kBlocked);
}

TEST(Follower, GoalInsideTheArmItselfIsRefused) {
  Bench bench;
  const Joints start = robot::testing::working();
  RigidTransform X_BE = bench.slingAt(start);
  for (const Eigen::Vector3d& inside : {Eigen::Vector3d(0.0, 0.0, 0.15), Eigen::Vector3d(0.0, 0.05, 0.31)}) {
    X_BE.translation() = inside;
    const FollowStep step = bench.step(X_BE, restAt(start), after(0));
    EXPECT_FALSE(step.isNew()) << id(step.outcome);
    EXPECT_FALSE(step.trajectory.valid());
  }
}

TEST(Follower, GoalThatIsNoNumberIsOutOfReach) {
  Bench bench;
  const Joints start = robot::testing::working();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const int at : {0, 5, 12, 14}) {  // of the rotation, of the translation
    ToolGoal goal = ToolGoal::resting(bench.slingAt(start));
    goal.X_BE.matrix()(at) = nan;
    EXPECT_EQ(bench.step(goal, restAt(start), after(0)).outcome, FollowOutcome::kOutOfReach) << at;
    goal = ToolGoal::resting(bench.slingAt(start));
    goal.X_BE_soon.matrix()(at) = nan;
    const FollowStep step = bench.step(goal, restAt(start), after(0));
    if (step.isNew()) {
      EXPECT_TRUE(step.trajectory.goal().allFinite()) << at;
    }
  }
}

TEST(Follower, ClosedMovementBringsTheJointsBack) {
  Bench bench;
  const Joints start = robot::testing::working();
  const RigidTransform X_start = bench.slingAt(start);
  robot::Trajectory trajectory = robot::Trajectory::rest(start, after(0));
  constexpr double round_s = 20.0, rounds = 5.0;
  for (double t = 0.0; t < rounds * round_s + 2.0; t += kStep_s) {
    const double a = 2.0 * M_PI * std::min(t / round_s, rounds);
    RigidTransform X_BE = X_start * Eigen::AngleAxisd(0.3 * std::sin(a), Eigen::Vector3d::UnitX());
    X_BE.pretranslate(
        Eigen::Vector3d(0.05 * std::sin(a), 0.12 * (1.0 - std::cos(a)), 0.06 * std::sin(2.0 * a)));
    const FollowStep step = bench.step(X_BE, trajectory.at(after(t)), after(t));
    if (step.isNew()) trajectory = step.trajectory;
  }
  EXPECT_LT((trajectory.goal() - start).cwiseAbs().maxCoeff(), 0.04);
}

TEST(Follower, FollowsASwingingGoalSmoothlyAndArrives) {
  Bench bench;
  const Joints start = robot::testing::working();
  const RigidTransform X_start = bench.slingAt(start);
  robot::Trajectory trajectory = robot::Trajectory::rest(start, after(0));
  double largest_lag = 0.0, last_lag = 0.0, largest_jerk = 0.0;
  for (double t = 0.0; t < 12.0; t += kStep_s) {
    RigidTransform X_BE = X_start;
    X_BE.translation().y() += 0.06 * (1.0 - std::cos(0.25 * 2.0 * M_PI * std::min(t, 10.0)));
    const MotionState commanded = trajectory.at(after(t));
    const FollowStep step = bench.step(X_BE, commanded, after(t));
    ASSERT_TRUE(step.isNew() || step.outcome == FollowOutcome::kHeld) << id(step.outcome) << " at " << t;
    if (step.isNew()) {
      const TimePoint begin = step.trajectory.start();
      const Joints before = trajectory.at(begin).a_rad_s2;
      largest_jerk = std::max(largest_jerk, (step.trajectory.at(begin).a_rad_s2 - before).norm());
      trajectory = step.trajectory;
    }
    last_lag =
        (bench.slingAt(trajectory.at(after(t + kStep_s)).q_rad).translation() - X_BE.translation()).norm();
    largest_lag = std::max(largest_lag, last_lag);
  }
  EXPECT_LT(largest_jerk, 1e-9);
  EXPECT_LT(largest_lag, 0.05);
  EXPECT_LT(last_lag, 2e-4);
}

}  // namespace mirrorarm::control
