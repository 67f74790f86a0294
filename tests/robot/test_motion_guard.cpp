#include <limits>

#include <gtest/gtest.h>

#include "core/robot/kinematics.h"
#include "core/robot/motion_guard.h"
#include "core/robot/trajectory.h"
#include "tests/robot/arms.h"
#include "tests/robot/guard_mischief.h"
#include "tests/robot/guard_wire.h"

namespace mirrorarm::robot {
namespace {

constexpr double kPeriod_s = 0.001;
constexpr double kRounding = 1.0 + 1e-5;

MotionLimits therapy() { return *limitsOf("therapy", testing::lbr()); }

/// The guard with its arm, cycle by cycle.
class Guard {
 public:
  explicit Guard(const MotionLimits& allowed = therapy())
      : limits(allowed), kinematics(testing::lbr()), watch(testing::lbr(), limits, kPeriod_s) {
    rest(testing::working());
  }

  void rest(const Joints& q) {
    last = restAt(q);
    watch.restart(q);
  }
  Guarded step(const MotionState& wish) {
    const Jacobian J = kinematics.jacobian(last.q_rad);
    return take(guardMotion(wish, last, {.jacobian = J, .clearances = rows}, kPeriod_s, limits));
  }
  Guarded brake(const MotionLimits& allowed) {
    const Jacobian J = kinematics.jacobian(last.q_rad);
    return take(brakeMotion(last, {.jacobian = J, .clearances = rows}, kPeriod_s, allowed));
  }
  /// Goes on as `wish` does until it rests or for so many cycles.
  void toward(const Joints& q, int cycles) {
    for (int i = 0; i < cycles; ++i) step({q, Joints::Zero(q.size()), Joints::Zero(q.size())});
  }
  [[nodiscard]] MotionState here() const { return {last.q_rad, Joints::Zero(7), Joints::Zero(7)}; }

  const MotionLimits limits;
  Kinematics kinematics;
  testing::WireWatch watch;
  testing::WireWorst worst;
  Commanded last;
  std::span<const ClearanceRow> rows;

 private:
  Guarded take(const Guarded& guarded) {
    last = guarded.command;
    testing::worsen(worst, watch.look(last.q_rad));
    return guarded;
  }
};

void expectWithin(const testing::WireWorst& worst) {
  EXPECT_LT(worst.position_rad, 1e-9);
  EXPECT_LT(worst.speed, kRounding);
  EXPECT_LT(worst.acceleration, kRounding);
  EXPECT_LT(worst.jerk, kRounding);
  EXPECT_LT(worst.tool_speed, kRounding);
  EXPECT_LT(worst.tool_acceleration, kRounding);
}

}  // namespace

TEST(MotionGuard, NoWishBreaksTheLimits) {
  Guard guard;
  testing::Mischief mischief(11);
  for (int cycle = 0; cycle < 200000; ++cycle) {
    const Jacobian J = guard.kinematics.jacobian(guard.last.q_rad);
    guard.step(mischief.wish(cycle, guard.last, J, kPeriod_s, guard.limits));
    ASSERT_TRUE(guard.last.q_rad.allFinite() && guard.last.v_rad_s.allFinite());
  }
  expectWithin(guard.worst);
}

TEST(MotionGuard, WishWithinTheLimitsPassesUnchanged) {
  Guard guard;
  MotionLimits inside = guard.limits;
  inside.max_speed_rad_s *= 0.99;
  inside.max_acceleration_rad_s2 *= 0.99;
  inside.max_jerk_rad_s3 *= 0.99;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> way(-0.1, 0.1);
  const TimePoint start{std::chrono::hours(1)};
  for (int round = 0; round < 20; ++round) {
    Joints goal = testing::working();
    for (double& angle : goal) angle += way(random);
    const Trajectory wished = Trajectory::quintic({testing::working(), Joints::Zero(7), Joints::Zero(7)},
                                                  goal, start, inside, Seconds(2.0));
    guard.rest(testing::working());
    for (int cycle = 1; cycle < 3000; ++cycle) {
      const MotionState state = wished.at(start + toClock(Seconds(cycle * kPeriod_s)));
      const Guarded guarded = guard.step(state);
      ASSERT_EQ(guarded.action, GuardAction::kPassed) << id(guarded.action) << " at " << cycle;
      ASSERT_EQ(guarded.command.q_rad, state.q_rad);
    }
  }
}

TEST(MotionGuard, JumpedWishIsReachedWithoutOvershoot) {
  Guard guard;
  Joints goal = testing::working();
  goal[0] += 0.1;
  goal[3] -= 0.05;
  double overshoot = 0.0;
  for (int cycle = 0; cycle < 4000; ++cycle) {
    guard.toward(goal, 1);
    overshoot = std::max({overshoot, guard.last.q_rad[0] - goal[0], goal[3] - guard.last.q_rad[3]});
  }
  EXPECT_LT((guard.last.q_rad - goal).norm(), 1e-9);
  EXPECT_LT(overshoot, 1e-7);
  expectWithin(guard.worst);
}

TEST(MotionGuard, CatchesUpWithAMovingWishAfterAJump) {
  Guard guard;
  MotionState wish = guard.here();
  wish.v_rad_s[6] = 0.1;
  guard.last.v_rad_s = wish.v_rad_s;
  wish.q_rad[6] += 0.01;
  double ahead = 0.0;
  GuardAction action = GuardAction::kPassed;
  for (int cycle = 0; cycle < 3000; ++cycle) {
    wish.q_rad[6] += 0.1 * kPeriod_s;
    action = guard.step(wish).action;
    ahead = std::max(ahead, guard.last.q_rad[6] - wish.q_rad[6]);
  }
  EXPECT_EQ(action, GuardAction::kPassed);
  EXPECT_LT((guard.last.q_rad - wish.q_rad).norm(), 1e-9);
  EXPECT_LT(ahead, 1e-7);
}

TEST(MotionGuard, WishALittleOutsideIsFollowedCalmly) {
  Guard guard;
  double changes = 0.0, off = 0.0;
  const double amplitude = 0.1, hertz = 1.02 * 0.24 / amplitude;  // 2 % too fast for A5
  Joints a_before = guard.last.a_rad_s2;
  for (int cycle = 1; cycle < 6000; ++cycle) {
    const double t = cycle * kPeriod_s, ease = std::min(1.0, t / 2.0);
    MotionState wish = guard.here();
    wish.q_rad = testing::working();
    wish.q_rad[5] += ease * amplitude * std::sin(hertz * t);
    wish.v_rad_s[5] = ease * amplitude * hertz * std::cos(hertz * t);
    wish.a_rad_s2[5] = -ease * amplitude * hertz * hertz * std::sin(hertz * t);
    guard.step(wish);
    off = std::max(off, std::abs(guard.last.q_rad[5] - wish.q_rad[5]));
    changes += std::abs(guard.last.a_rad_s2[5] - a_before[5]);
    a_before = guard.last.a_rad_s2;
  }
  EXPECT_LT(off, 0.005);
  // A calm acceleration goes up and down once a swing; one that chatters goes thousands of times.
  EXPECT_LT(changes, 3.0 * 6.0 * hertz / 6.28 * 4.0 * amplitude * hertz * hertz);
}

TEST(MotionGuard, BrakesInAStraightLineWithinTheLimits) {
  Guard guard;
  Joints goal = testing::working();
  goal += (Joints(7) << 0.5, 0.25, 0.0, -0.6, 0.0, 0.5, 1.2).finished();
  guard.toward(goal, 900);
  const Joints direction = guard.last.v_rad_s.normalized(), start = guard.last.q_rad;
  ASSERT_GT(guard.last.v_rad_s.norm(), 0.2);
  int cycles = 0;
  while (guard.last.v_rad_s.norm() > 1e-12 && cycles < 1000) {
    guard.brake(guard.limits);
    ++cycles;
  }
  EXPECT_LT(cycles * kPeriod_s, 0.55);
  EXPECT_LT(((guard.last.q_rad - start).normalized() - direction).norm(), 0.02);
  expectWithin(guard.worst);
}

TEST(MotionGuard, ACalledStopMayBrakeHarder) {
  for (const double share : {1.0, 2.0}) {
    Guard guard;
    guard.toward(testing::working() + Joints::Constant(7, 0.5), 1200);
    const double speed = guard.last.v_rad_s.norm();
    MotionLimits limits = guard.limits;
    limits.stop_share = share;
    int cycles = 0;
    while (guard.last.v_rad_s.norm() > 1e-12 && cycles < 1000) {
      guard.brake(brakingLimits(limits));
      ++cycles;
    }
    EXPECT_GT(speed, 0.2);
    EXPECT_LT(cycles * kPeriod_s, share == 1.0 ? 0.55 : 0.30);
  }
}

TEST(MotionGuard, WhatIsNotFiniteBrakes) {
  Guard guard;
  guard.toward(testing::working() + Joints::Constant(7, 0.3), 500);
  const double speed = guard.last.v_rad_s[2];
  MotionState wish = guard.here();
  wish.q_rad[0] = std::nan("");
  for (int i = 0; i < 50; ++i) EXPECT_EQ(guard.step(wish).action, GuardAction::kNotFinite);
  EXPECT_LT(guard.last.v_rad_s[2], speed);
  expectWithin(guard.worst);
}

TEST(MotionGuard, ARobotThatIsElsewhereIsBraked) {
  Guard guard;
  guard.toward(testing::working() + Joints::Constant(7, 0.3), 500);
  const double speed = guard.last.v_rad_s[2];
  for (int i = 0; i < 50; ++i) {
    const Jacobian J = guard.kinematics.jacobian(guard.last.q_rad);
    const Surroundings around{.jacobian = J, .following_error_rad = 0.11};
    const Guarded guarded = guardMotion(guard.here(), guard.last, around, kPeriod_s, guard.limits);
    EXPECT_EQ(guarded.action, GuardAction::kFollowingError);
    guard.last = guarded.command;
  }
  EXPECT_LT(guard.last.v_rad_s[2], speed);
}

TEST(MotionGuard, SaysWhichLimitActed) {
  Guard guard;
  const auto actionOn = [&](Eigen::Index joint, double step) {
    MotionState wish = guard.here();
    wish.q_rad[joint] += step;
    return guard.step(wish).action;
  };
  EXPECT_EQ(actionOn(0, 0.0), GuardAction::kPassed);
  EXPECT_EQ(actionOn(0, 1e-3), GuardAction::kJerk);
  for (int i = 0; i < 200; ++i) actionOn(6, 1.0);
  EXPECT_EQ(actionOn(6, 1.0), GuardAction::kAcceleration);
  for (int i = 0; i < 300; ++i) actionOn(6, 1.0);
  EXPECT_EQ(actionOn(6, 1.0), GuardAction::kSpeed);
  Joints far = testing::working();
  far[6] = guard.limits.upper_rad[6] + 0.1;
  guard.toward(far, 20000);
  EXPECT_EQ(actionOn(6, 0.1), GuardAction::kPosition);
  EXPECT_NEAR(guard.last.q_rad[6], guard.limits.upper_rad[6], 1e-6);
}

TEST(MotionGuard, FromOutsideTheRangeItOnlyComesBack) {
  Guard guard;
  Joints q = testing::working();
  q[1] = guard.limits.lower_rad[1] - 0.02;
  guard.rest(q);
  MotionState wish = guard.here();
  wish.q_rad[1] -= 0.1;
  for (int i = 0; i < 100; ++i) guard.step(wish);
  EXPECT_GE(guard.last.q_rad[1], q[1]);
  guard.toward(testing::working(), 100);
  EXPECT_GT(guard.last.q_rad[1], q[1]);
}

TEST(MotionGuard, WhatIsSentCarriesItsStop) {
  Guard guard;
  testing::Mischief mischief(5);
  for (int round = 0; round < 40; ++round) {
    for (int cycle = 0; cycle < 300; ++cycle)
      guard.step(mischief.wish(cycle + 100 * round, guard.last, guard.kinematics.jacobian(guard.last.q_rad),
                               kPeriod_s, guard.limits));
    const Commanded saved = guard.last;
    const Joints rest = restOf(guard.last, kPeriod_s);
    MotionState nothing = guard.here();
    nothing.q_rad[0] = std::nan("");
    const int cycles = guard.last.stop.cycles();
    for (int i = 0; i < cycles; ++i) guard.step(nothing);
    EXPECT_LT(guard.last.v_rad_s.norm(), 1e-12);
    EXPECT_LT((guard.last.q_rad - rest).norm(), 1e-12) << saved.stop.cycles();
  }
  expectWithin(guard.worst);
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
