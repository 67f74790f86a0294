#include "core/control/stop_category.h"

namespace mirrorarm::control {

std::string_view id(StopCategory category) {
  switch (category) {
    case StopCategory::kNone:
      return "none";
    case StopCategory::kTwo:
      return "2";
    case StopCategory::kOne:
      return "1";
  }
  return "unknown";
}

StopCategory categoryOf(StopReason reason) noexcept {
  switch (reason) {
    case StopReason::kNone:
      return StopCategory::kNone;
    case StopReason::kOperator:
    case StopReason::kEnablingReleased:
    case StopReason::kEnablingPressedThrough:
    case StopReason::kCameraSilent:
    case StopReason::kTargetLost:
    case StopReason::kPlannerSilent:
    case StopReason::kForce:
    case StopReason::kInternal:
      return StopCategory::kTwo;
    case StopReason::kRobotSilent:
    case StopReason::kRobotFault:
    case StopReason::kPoorLine:
    case StopReason::kServoLate:
    case StopReason::kFollowingError:
      break;
  }
  return StopCategory::kOne;
}

}  // namespace mirrorarm::control
