#include "core/control/stop_reason.h"

namespace mirrorarm::control {

std::string_view id(StopReason reason) {
  switch (reason) {
    case StopReason::kNone:
      return "none";
    case StopReason::kOperator:
      return "operator";
    case StopReason::kCameraSilent:
      return "camera_silent";
    case StopReason::kTargetLost:
      return "target_lost";
    case StopReason::kRobotSilent:
      return "robot_silent";
    case StopReason::kRobotFault:
      return "robot_fault";
    case StopReason::kServoLate:
      return "servo_late";
    case StopReason::kFollowingError:
      return "following_error";
    case StopReason::kInternal:
      return "internal";
    case StopReason::kPoorLine:
      return "poor_line";
    case StopReason::kPlannerSilent:
      return "planner_silent";
    case StopReason::kEnablingReleased:
      return "enabling_released";
    case StopReason::kEnablingPressedThrough:
      return "enabling_pressed_through";
    case StopReason::kForce:
      return "force";
  }
  return "unknown";
}

}  // namespace mirrorarm::control
