#include "core/control/supervisor.h"

namespace mirrorarm::control {
namespace {

using robot::LinkFault;

bool olderThan(TimePoint time, Seconds age, TimePoint now) { return secondsBetween(time, now) > age.count(); }

StopReason linkTrouble(LinkFault fault) {
  switch (fault) {
    case LinkFault::kNone:
    case LinkFault::kNoAnswer:  // its age tells
      return StopReason::kNone;
    case LinkFault::kPoorLine:
      return StopReason::kPoorLine;
    case LinkFault::kNotReady:
    case LinkFault::kDriveFault:
      break;
  }
  return StopReason::kRobotFault;
}

StopReason robotTrouble(const Vitals& vitals, const SupervisorSettings& settings) {
  if (olderThan(vitals.last_cycle, settings.servo_late_after, vitals.now)) return StopReason::kServoLate;
  if (const auto reason = linkTrouble(vitals.fault); reason != StopReason::kNone) return reason;
  if (olderThan(vitals.last_robot, settings.robot_silent_after, vitals.now)) return StopReason::kRobotSilent;
  const double most = vitals.gives_way ? settings.max_deflection_rad : settings.max_following_error_rad;
  // Written so that a number that is none counts as trouble.
  if (!(vitals.following_error_rad <= most)) return StopReason::kFollowingError;
  return StopReason::kNone;
}

StopReason operatorTrouble(const Vitals& vitals, const SupervisorSettings& settings) {
  if (!settings.enabling_needed || !(vitals.following || vitals.moving)) return StopReason::kNone;
  switch (vitals.enabling) {
    case EnablingPosition::kEnabled:
      return StopReason::kNone;
    case EnablingPosition::kPressedThrough:
      return StopReason::kEnablingPressedThrough;
    case EnablingPosition::kReleased:
      break;
  }
  return StopReason::kEnablingReleased;
}

StopReason targetTrouble(const Vitals& vitals, const SupervisorSettings& settings) {
  if (olderThan(vitals.last_decision, settings.planner_silent_after, vitals.now))
    return StopReason::kPlannerSilent;
  if (olderThan(vitals.last_frame, settings.camera_silent_after, vitals.now))
    return StopReason::kCameraSilent;
  if (olderThan(vitals.last_target, settings.stop_after, vitals.now)) return StopReason::kTargetLost;
  return StopReason::kNone;
}

/// Since when the one is silent whose silence is the reason; nothing heard ever: now.
TimePoint silentSince(StopReason reason, const Vitals& vitals) {
  TimePoint heard = vitals.now;
  if (reason == StopReason::kCameraSilent) heard = vitals.last_frame;
  if (reason == StopReason::kTargetLost) heard = vitals.last_target;
  if (reason == StopReason::kPlannerSilent) heard = vitals.last_decision;
  return heard == TimePoint{} ? vitals.now : heard;
}

Seconds patienceWith(StopReason reason, const SupervisorSettings& settings) {
  if (reason == StopReason::kCameraSilent) return settings.camera_silent_after;
  if (reason == StopReason::kPlannerSilent) return settings.planner_silent_after;
  return settings.hold_after;
}

}  // namespace

std::string_view id(Permit permit) {
  switch (permit) {
    case Permit::kMove:
      return "move";
    case Permit::kHold:
      return "hold";
    case Permit::kStop:
      return "stop";
  }
  return "unknown";
}

Verdict supervise(const Vitals& vitals, const SupervisorSettings& settings) noexcept {
  if (const auto reason = robotTrouble(vitals, settings); reason != StopReason::kNone)
    return {Permit::kStop, reason};
  if (const auto reason = operatorTrouble(vitals, settings); reason != StopReason::kNone)
    return {Permit::kStop, reason};
  if (vitals.force == ForceLevel::kTooMuch) return {Permit::kStop, StopReason::kForce};
  if (!vitals.following) return {};
  if (const auto reason = targetTrouble(vitals, settings); reason != StopReason::kNone)
    return {Permit::kStop, reason};
  if (olderThan(vitals.last_target, settings.hold_after, vitals.now))
    return {Permit::kHold, StopReason::kNone};
  return {};
}

StopCategory categoryNow(const Stop& stop, StopReason trouble, bool at_rest, const Vitals& vitals,
                         const SupervisorSettings& settings) noexcept {
  if (stop.reason == StopReason::kNone) return StopCategory::kNone;
  const StopCategory known = graver(stop.category, graver(categoryOf(stop.reason), categoryOf(trouble)));
  const bool silence_lasts =
      olderThan(silentSince(stop.reason, vitals), settings.drives_off_after, vitals.now);
  const bool brakes_badly = !at_rest && olderThan(stop.since, settings.braking_time, vitals.now);
  return silence_lasts || brakes_badly ? StopCategory::kOne : known;
}

StopReason lastingCause(const Stop& stop, StopReason trouble, const Vitals& vitals,
                        const SupervisorSettings& settings) noexcept {
  if (trouble != StopReason::kNone) return trouble;
  const bool still_silent =
      olderThan(silentSince(stop.reason, vitals), patienceWith(stop.reason, settings), vitals.now);
  const bool still_pressed = stop.reason == StopReason::kEnablingPressedThrough &&
                             vitals.enabling == EnablingPosition::kPressedThrough;
  const bool still_forced = stop.reason == StopReason::kForce && vitals.force != ForceLevel::kCalm;
  return still_silent || still_pressed || still_forced ? stop.reason : StopReason::kNone;
}

}  // namespace mirrorarm::control
