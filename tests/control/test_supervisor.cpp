#include <cmath>

#include <gtest/gtest.h>

#include "core/control/supervisor.h"

namespace mirrorarm::control {
namespace {

/// All is well at one time.
Vitals healthy() {
  const TimePoint now{std::chrono::hours(2)};
  Vitals vitals;
  vitals.now = vitals.last_frame = vitals.last_target = vitals.last_decision = now;
  vitals.last_robot = vitals.last_cycle = now;
  vitals.following = true;
  return vitals;
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
  vitals = healthy();
  vitals.following = false;
  vitals.fault = robot::LinkFault::kPoorLine;
  EXPECT_EQ(reasonFor(vitals), StopReason::kPoorLine);
  vitals.fault = robot::LinkFault::kNotReady;
  EXPECT_EQ(reasonFor(vitals), StopReason::kRobotFault);
  vitals.fault = robot::LinkFault::kNoAnswer;
  EXPECT_EQ(reasonFor(vitals), StopReason::kNone) << "its age tells";
}

TEST(Supervisor, SpringsMayGiveWayFurther) {
  Vitals vitals = healthy();
  vitals.gives_way = true;
  vitals.following_error_rad = 0.4;
  EXPECT_EQ(reasonFor(vitals), StopReason::kNone);
  vitals.following_error_rad = 0.6;
  EXPECT_EQ(reasonFor(vitals), StopReason::kFollowingError);
}

TEST(Supervisor, SilentPlannerIsToldFromASilentCamera) {
  Vitals vitals = healthy();
  age(vitals.last_decision, 0.151);
  age(vitals.last_frame, 0.240);
  EXPECT_EQ(reasonFor(vitals), StopReason::kPlannerSilent);
  vitals.following = false;
  EXPECT_EQ(reasonFor(vitals), StopReason::kNone);
}

TEST(Supervisor, EnablingDeviceMattersWhileTheRobotMovesOrFollows) {
  SupervisorSettings settings;
  settings.enabling_needed = true;
  const auto reason = [&](EnablingPosition position, bool following, bool moving) {
    Vitals vitals = healthy();
    vitals.enabling = position;
    vitals.following = following;
    vitals.moving = moving;
    return supervise(vitals, settings).reason;
  };
  EXPECT_EQ(reason(EnablingPosition::kEnabled, true, true), StopReason::kNone);
  EXPECT_EQ(reason(EnablingPosition::kReleased, true, false), StopReason::kEnablingReleased);
  EXPECT_EQ(reason(EnablingPosition::kReleased, false, true), StopReason::kEnablingReleased);
  EXPECT_EQ(reason(EnablingPosition::kPressedThrough, false, true), StopReason::kEnablingPressedThrough);
  EXPECT_EQ(reason(EnablingPosition::kReleased, false, false), StopReason::kNone);
  settings.enabling_needed = false;
  EXPECT_EQ(reason(EnablingPosition::kReleased, true, true), StopReason::kNone);
}

TEST(Supervisor, TooMuchForceStopsAlsoWhenNotFollowing) {
  Vitals vitals = healthy();
  vitals.following = false;
  vitals.force = ForceLevel::kSoften;
  EXPECT_EQ(reasonFor(vitals), StopReason::kNone);
  vitals.force = ForceLevel::kTooMuch;
  EXPECT_EQ(reasonFor(vitals), StopReason::kForce);
}

TEST(StopCategories, EveryReasonHasOne) {
  EXPECT_EQ(categoryOf(StopReason::kNone), StopCategory::kNone);
  for (int i = 1; i < kStopReasonCount; ++i) {
    const auto reason = static_cast<StopReason>(i);
    const bool in_doubt = reason == StopReason::kRobotSilent || reason == StopReason::kRobotFault ||
                          reason == StopReason::kPoorLine || reason == StopReason::kServoLate ||
                          reason == StopReason::kFollowingError;
    EXPECT_EQ(categoryOf(reason), in_doubt ? StopCategory::kOne : StopCategory::kTwo) << id(reason);
  }
}

TEST(StopCategories, SilenceOfASecondTakesTheDrivesAway) {
  for (const auto reason : {StopReason::kCameraSilent, StopReason::kTargetLost, StopReason::kPlannerSilent}) {
    Vitals vitals = healthy();
    vitals.following = false;  // the session is paused by then
    const Stop stop{reason, StopCategory::kTwo, vitals.now};
    const auto category = [&](double silence_s) {
      Vitals later = vitals;
      later.now += toClock(Seconds(silence_s));
      return categoryNow(stop, StopReason::kNone, true, later, {});
    };
    EXPECT_EQ(category(0.999), StopCategory::kTwo) << id(reason);
    EXPECT_EQ(category(1.001), StopCategory::kOne) << id(reason);
  }
}

TEST(StopCategories, BadBrakingAndFurtherTroubleMakeItGraverAndNothingMilder) {
  const Vitals vitals = healthy();
  const Stop fresh{StopReason::kOperator, StopCategory::kTwo, vitals.now};
  const Stop old{StopReason::kOperator, StopCategory::kTwo, vitals.now - std::chrono::milliseconds(1001)};
  EXPECT_EQ(categoryNow(fresh, StopReason::kNone, false, vitals, {}), StopCategory::kTwo);
  EXPECT_EQ(categoryNow(old, StopReason::kNone, true, vitals, {}), StopCategory::kTwo);
  EXPECT_EQ(categoryNow(old, StopReason::kNone, false, vitals, {}), StopCategory::kOne);
  EXPECT_EQ(categoryNow(fresh, StopReason::kRobotSilent, false, vitals, {}), StopCategory::kOne);
  const Stop grave{StopReason::kOperator, StopCategory::kOne, vitals.now};
  EXPECT_EQ(categoryNow(grave, StopReason::kNone, true, vitals, {}), StopCategory::kOne);
}

TEST(LastingCause, IsWhatWouldStopAgain) {
  Vitals vitals = healthy();
  vitals.following = false;
  const auto lasting = [&](StopReason reason, StopReason trouble = StopReason::kNone) {
    return lastingCause({reason, StopCategory::kTwo, vitals.now}, trouble, vitals, {});
  };
  for (int i = 1; i < kStopReasonCount; ++i)
    EXPECT_EQ(lasting(static_cast<StopReason>(i)), StopReason::kNone) << "all is well again";
  EXPECT_EQ(lasting(StopReason::kOperator, StopReason::kRobotSilent), StopReason::kRobotSilent);
  age(vitals.last_frame, 0.3);
  age(vitals.last_target, 0.3);
  EXPECT_EQ(lasting(StopReason::kCameraSilent), StopReason::kCameraSilent);
  EXPECT_EQ(lasting(StopReason::kTargetLost), StopReason::kTargetLost);
  EXPECT_EQ(lasting(StopReason::kOperator), StopReason::kNone);
  age(vitals.last_decision, 0.3);
  EXPECT_EQ(lasting(StopReason::kPlannerSilent), StopReason::kPlannerSilent);
  vitals.enabling = EnablingPosition::kPressedThrough;
  EXPECT_EQ(lasting(StopReason::kEnablingPressedThrough), StopReason::kEnablingPressedThrough);
  vitals.force = ForceLevel::kWarning;
  EXPECT_EQ(lasting(StopReason::kForce), StopReason::kForce);
}

}  // namespace mirrorarm::control
