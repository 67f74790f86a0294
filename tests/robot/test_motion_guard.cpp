#include <limits>

#include <gtest/gtest.h>

#include "core/robot/kinematics.h"
#include "core/robot/motion_guard.h"
#include "core/robot/trajectory.h"
#include "tests/robot/arms.h"

namespace mirrorarm::robot {
namespace {

constexpr double kPeriod_s = 0.005;

MotionLimits therapy() { return *limitsOf("therapy", testing::lbr()); }

Commanded restAt(const Joints& q) { return {q, Joints::Zero(q.size())}; }

/// The worst that one long run did to the limits, as excess over them.
struct Worst {
  double position_rad = -1.0, speed = 0.0, acceleration = 0.0, tool = 0.0;

  void look(const Commanded& now, const Commanded& last, const Jacobian& J, const MotionLimits& limits) {
    position_rad = std::max(
        {position_rad, (now.q_rad - limits.upper_rad).maxCoeff(), (limits.lower_rad - now.q_rad).maxCoeff()});
    speed = std::max(speed, (now.v_rad_s.array().abs() / limits.max_speed_rad_s.array()).maxCoeff());
    const Joints a = (now.v_rad_s - last.v_rad_s) / kPeriod_s;
    acceleration =
        std::max(acceleration, (a.array().abs() / limits.max_acceleration_rad_s2.array()).maxCoeff());
    tool = std::max(tool, (J.topRows<3>() * now.v_rad_s).norm() / limits.max_tool_speed_m_s);
  }
};

/// Wishes that nobody in his senses would send, in runs of one kind.
class Mischief {
 public:
  explicit Mischief(unsigned seed) : random_(seed) {}

  Commanded wish(int cycle, const Commanded& last, const MotionLimits& limits) {
    if (cycle % 150 == 0) kind_ = static_cast<int>(random_() % 7);
    Commanded wish{last.q_rad, Joints::Zero(last.q_rad.size())};
    for (Eigen::Index j = 0; j < last.q_rad.size(); ++j) bend(wish, j, cycle, limits);
    return wish;
  }

 private:
  void bend(Commanded& wish, Eigen::Index j, int cycle, const MotionLimits& limits) {
    const double middle = 0.5 * (limits.lower_rad[j] + limits.upper_rad[j]);
    switch (kind_) {
      case 0:
        wish.q_rad[j] = any(3.0);
        break;
      case 1:
        wish.q_rad[j] += any(0.01);
        break;
      case 2:
        wish.q_rad[j] = random_() % 40 == 0 ? nonsense() : wish.q_rad[j] + any(0.002);
        break;
      case 3:
        wish.q_rad[j] = limits.upper_rad[j] + 0.5;
        break;
      case 4:
        wish.q_rad[j] = limits.lower_rad[j] - 0.5;
        break;
      case 5:
        wish.q_rad[j] = middle + (cycle / 30 % 2 == 0 ? 1.0 : -1.0);
        break;
      default:
        wish.q_rad[j] += 0.0012;
        break;
    }
    wish.v_rad_s[j] = random_() % 3 == 0 ? any(100.0) : random_() % 50 == 0 ? nonsense() : any(0.3);
  }
  double any(double size) { return std::uniform_real_distribution<double>(-size, size)(random_); }
  double nonsense() {
    const std::array all = {std::nan(""), std::numeric_limits<double>::infinity(), -1e300, 1e300};
    return all[random_() % all.size()];
  }

  std::mt19937 random_;
  int kind_ = 0;
};

}  // namespace

TEST(MotionGuard, NoWishBreaksTheJointLimits) {
  const MotionLimits limits = therapy();
  const Kinematics kinematics(testing::lbr());
  Mischief mischief(11);
  Commanded last = restAt(testing::working());
  Worst worst;
  for (int cycle = 0; cycle < 200000; ++cycle) {
    const Jacobian J = kinematics.jacobian(last.q_rad);
    const Commanded next =
        guardMotion(mischief.wish(cycle, last, limits), last, J, kPeriod_s, limits).command;
    ASSERT_TRUE(next.q_rad.allFinite() && next.v_rad_s.allFinite());
    worst.look(next, last, J, limits);
    last = next;
  }
  EXPECT_LT(worst.position_rad, 1e-8);
  EXPECT_LT(worst.speed, 1.0 + 1e-5);
  EXPECT_LT(worst.acceleration, 1.0 + 1e-5);
  EXPECT_LT(worst.tool, 1.05);
}

TEST(MotionGuard, WishWithinTheLimitsPassesUnchanged) {
  const MotionLimits limits = therapy();
  const Kinematics kinematics(testing::lbr());
  std::mt19937 random(3);
  std::uniform_real_distribution<double> way(-0.3, 0.3);
  const TimePoint start{std::chrono::hours(1)};
  for (int round = 0; round < 20; ++round) {
    Joints goal = testing::working();
    for (double& angle : goal) angle += way(random);
    const Trajectory wished = Trajectory::quintic({testing::working(), Joints::Zero(7), Joints::Zero(7)},
                                                  goal, start, limits, Seconds(4.0));
    Commanded last = restAt(testing::working());
    for (int cycle = 1; cycle < 1200; ++cycle) {
      const MotionState state = wished.at(start + toClock(Seconds(cycle * kPeriod_s)));
      const Guarded guarded =
          guardMotion({state.q_rad, state.v_rad_s}, last, kinematics.jacobian(last.q_rad), kPeriod_s, limits);
      ASSERT_EQ(guarded.action, GuardAction::kPassed) << id(guarded.action) << " at " << cycle;
      ASSERT_EQ(guarded.command.q_rad, state.q_rad);
      last = guarded.command;
    }
  }
}

TEST(MotionGuard, JumpedWishIsReachedWithoutOvershoot) {
  const MotionLimits limits = therapy();
  const Kinematics kinematics(testing::lbr());
  Commanded last = restAt(testing::working());
  Commanded wish = last;
  wish.q_rad[0] += 0.1;
  wish.q_rad[3] -= 0.05;
  double overshoot = 0.0;
  for (int cycle = 0; cycle < 600; ++cycle) {
    last = guardMotion(wish, last, kinematics.jacobian(last.q_rad), kPeriod_s, limits).command;
    overshoot = std::max({overshoot, last.q_rad[0] - wish.q_rad[0], wish.q_rad[3] - last.q_rad[3]});
  }
  EXPECT_LT((last.q_rad - wish.q_rad).norm(), 1e-9);
  EXPECT_LT(overshoot, 1e-9);
}

TEST(MotionGuard, CatchesUpWithAMovingWishAfterAJump) {
  const MotionLimits limits = therapy();
  const Kinematics kinematics(testing::lbr());
  Commanded last = restAt(testing::working());
  Commanded wish = last;
  wish.v_rad_s[6] = 0.1;
  last.v_rad_s = wish.v_rad_s;
  wish.q_rad[6] += 0.01;
  double ahead = 0.0;
  GuardAction action = GuardAction::kPassed;
  for (int cycle = 0; cycle < 300; ++cycle) {
    wish.q_rad[6] += 0.1 * kPeriod_s;
    const Guarded guarded = guardMotion(wish, last, kinematics.jacobian(last.q_rad), kPeriod_s, limits);
    last = guarded.command;
    action = guarded.action;
    ahead = std::max(ahead, last.q_rad[6] - wish.q_rad[6]);
  }
  EXPECT_EQ(action, GuardAction::kPassed);
  EXPECT_LT((last.q_rad - wish.q_rad).norm(), 1e-9);
  EXPECT_LT(ahead, 1e-9);
}

TEST(MotionGuard, BrakesInAStraightLineWithinTheLimits) {
  const MotionLimits limits = therapy();
  const Kinematics kinematics(testing::lbr());
  Commanded last = restAt(testing::working());
  last.v_rad_s << 0.1, 0.05, 0.0, -0.12, 0.0, 0.1, 0.24;
  const Joints direction = last.v_rad_s.normalized(), start = last.q_rad;
  int cycles = 0;
  while (last.v_rad_s.norm() > 0.0 && cycles < 1000) {
    const Jacobian J = kinematics.jacobian(last.q_rad);
    const Commanded next = brakeMotion(last, J, kPeriod_s, limits).command;
    Worst worst;
    worst.look(next, last, J, limits);
    EXPECT_LE(worst.acceleration, 1.0 + 1e-9);
    last = next;
    ++cycles;
  }
  EXPECT_LT(cycles * kPeriod_s, 0.5);
  EXPECT_LT(((last.q_rad - start).normalized() - direction).norm(), 1e-9);
}

TEST(MotionGuard, WhatIsNotFiniteBrakes) {
  const MotionLimits limits = therapy();
  const Kinematics kinematics(testing::lbr());
  Commanded last = restAt(testing::working());
  last.v_rad_s[2] = 0.1;
  Commanded wish = last;
  wish.q_rad[0] = std::nan("");
  const Guarded guarded = guardMotion(wish, last, kinematics.jacobian(last.q_rad), kPeriod_s, limits);
  EXPECT_EQ(guarded.action, GuardAction::kNotFinite);
  EXPECT_LT(guarded.command.v_rad_s[2], 0.1);
}

TEST(MotionGuard, SaysWhichLimitActed) {
  const MotionLimits limits = therapy();
  const Kinematics kinematics(testing::lbr());
  const auto actionOn = [&](Commanded last, double step) {
    Commanded wish = last;
    wish.q_rad[0] += step;
    return guardMotion(wish, last, kinematics.jacobian(last.q_rad), kPeriod_s, limits).action;
  };
  Commanded last = restAt(testing::working());
  EXPECT_EQ(actionOn(last, 0.0), GuardAction::kPassed);
  EXPECT_EQ(actionOn(last, 1e-4), GuardAction::kAcceleration);
  EXPECT_EQ(actionOn(last, 0.005), GuardAction::kSpeed);
  last.q_rad[0] = limits.upper_rad[0];
  EXPECT_EQ(actionOn(last, 0.1), GuardAction::kPosition);
}

TEST(MotionGuard, FromOutsideTheRangeItOnlyComesBack) {
  const MotionLimits limits = therapy();
  const Kinematics kinematics(testing::lbr());
  Commanded last = restAt(testing::working());
  last.q_rad[1] = limits.lower_rad[1] - 0.02;
  Commanded wish = last;
  wish.q_rad[1] -= 0.1;
  const Jacobian J = kinematics.jacobian(last.q_rad);
  EXPECT_EQ(guardMotion(wish, last, J, kPeriod_s, limits).command.q_rad[1], last.q_rad[1]);
  wish.q_rad[1] += 0.5;
  EXPECT_GT(guardMotion(wish, last, J, kPeriod_s, limits).command.q_rad[1], last.q_rad[1]);
}

TEST(MotionLimits, ProfilesDifferInTheTool) {
  const ArmDescription lbr = testing::lbr();
  EXPECT_EQ(limitProfiles().size(), 3U);
  for (const auto profile : limitProfiles()) ASSERT_TRUE(limitsOf(profile, lbr));
  EXPECT_FALSE(limitsOf("full", lbr));
  const MotionLimits limits = therapy();
  EXPECT_NEAR(limits.max_speed_rad_s.maxCoeff(), 0.24, 1e-12);
  EXPECT_NEAR(limits.max_acceleration_rad_s2[1], 0.5, 1e-12);
  EXPECT_NEAR(limits.max_acceleration_rad_s2[2], 0.8, 1e-12);
  EXPECT_NEAR(limits.upper_rad[0], lbr.joints[0].upper_rad - 0.035, 1e-12);
  EXPECT_NEAR(limitsOf("head", lbr)->max_tool_speed_m_s, 0.13, 1e-12);
}

}  // namespace mirrorarm::robot
