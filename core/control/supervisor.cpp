#include "core/control/supervisor.h"

namespace mirrorarm::control {
namespace {

bool olderThan(TimePoint time, Seconds age, TimePoint now) { return secondsBetween(time, now) > age.count(); }

StopReason robotTrouble(const Vitals& vitals, const SupervisorSettings& settings) {
  if (olderThan(vitals.last_cycle, settings.servo_late_after, vitals.now)) return StopReason::kServoLate;
  if (olderThan(vitals.last_robot, settings.robot_silent_after, vitals.now)) return StopReason::kRobotSilent;
  // Written so that a number that is none counts as trouble.
  if (!(vitals.following_error_rad <= settings.max_following_error_rad)) return StopReason::kFollowingError;
  return StopReason::kNone;
}

StopReason targetTrouble(const Vitals& vitals, const SupervisorSettings& settings) {
  if (olderThan(vitals.last_frame, settings.camera_silent_after, vitals.now))
    return StopReason::kCameraSilent;
  if (olderThan(vitals.last_target, settings.stop_after, vitals.now)) return StopReason::kTargetLost;
  return StopReason::kNone;
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
  if (!vitals.following) return {};
  if (const auto reason = targetTrouble(vitals, settings); reason != StopReason::kNone)
    return {Permit::kStop, reason};
  if (olderThan(vitals.last_target, settings.hold_after, vitals.now))
    return {Permit::kHold, StopReason::kNone};
  return {};
}

}  // namespace mirrorarm::control
