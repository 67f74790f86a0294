#include <cmath>

#include <gtest/gtest.h>

#include "core/control/supervisor.h"

namespace mirrorarm::control {
namespace {

/// All is well at one time.
Vitals healthy() {
  const TimePoint now{std::chrono::hours(2)};
  return {now, now, now, now, now, 0.0, true};
}

void age(TimePoint& time, double seconds) { time -= toClock(Seconds(seconds)); }

StopReason reasonFor(const Vitals& vitals) { return supervise(vitals, {}).reason; }

}  // namespace

TEST(Supervisor, HealthyMoves) { EXPECT_EQ(supervise(healthy(), {}).permit, Permit::kMove); }

TEST(Supervisor, AgeingTargetHoldsThenStops) {
  Vitals vitals = healthy();
  age(vitals.last_target, 0.099);
  EXPECT_EQ(supervise(vitals, {}).permit, Permit::kMove);
  age(vitals.last_target, 0.002);
  EXPECT_EQ(supervise(vitals, {}).permit, Permit::kHold);
  EXPECT_EQ(reasonFor(vitals), StopReason::kNone);
  age(vitals.last_target, 0.150);
  EXPECT_EQ(supervise(vitals, {}).permit, Permit::kStop);
  EXPECT_EQ(reasonFor(vitals), StopReason::kTargetLost);
  vitals.following = false;
  EXPECT_EQ(supervise(vitals, {}).permit, Permit::kMove);
}

TEST(Supervisor, SilentCamera) {
  Vitals vitals = healthy();
  age(vitals.last_frame, 0.251);
  age(vitals.last_target, 0.251);
  EXPECT_EQ(reasonFor(vitals), StopReason::kCameraSilent);
}

TEST(Supervisor, RobotIsWatchedAlsoWhenNotFollowing) {
  Vitals vitals = healthy();
  vitals.following = false;
  age(vitals.last_robot, 0.051);
  EXPECT_EQ(reasonFor(vitals), StopReason::kRobotSilent);
  vitals = healthy();
  age(vitals.last_cycle, 0.101);
  EXPECT_EQ(reasonFor(vitals), StopReason::kServoLate);
  vitals = healthy();
  vitals.following_error_rad = 0.11;
  EXPECT_EQ(reasonFor(vitals), StopReason::kFollowingError);
  vitals.following_error_rad = std::nan("");
  EXPECT_EQ(reasonFor(vitals), StopReason::kFollowingError);
}

}  // namespace mirrorarm::control
