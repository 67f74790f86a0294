#include "core/control/servo_state.h"

namespace mirrorarm::control {

std::string_view id(ResetRefusal refusal) {
  switch (refusal) {
    case ResetRefusal::kNone:
      return "none";
    case ResetRefusal::kNotStopped:
      return "not_stopped";
    case ResetRefusal::kMoving:
      return "moving";
    case ResetRefusal::kCausePersists:
      return "cause_persists";
  }
  return "unknown";
}

std::string_view id(MotionRefusal refusal) {
  switch (refusal) {
    case MotionRefusal::kNone:
      return "none";
    case MotionRefusal::kStopped:
      return "stopped";
    case MotionRefusal::kNotEnabled:
      return "not_enabled";
    case MotionRefusal::kStartElsewhere:
      return "start_elsewhere";
    case MotionRefusal::kRobotNotReady:
      return "robot_not_ready";
  }
  return "unknown";
}

}  // namespace mirrorarm::control
