#pragma once

#include <cstdint>
#include <string_view>

namespace mirrorarm::control {

/// Why the robot was brought to rest. A stop is latched until it is reset; resetting never starts a motion.
enum class StopReason : std::uint8_t {
  kNone,
  kOperator,                ///< somebody pressed STOP
  kCameraSilent,            ///< no frame for too long
  kTargetLost,              ///< frames come, the target does not
  kRobotSilent,             ///< the robot does not answer
  kRobotFault,              ///< the robot says that it cannot move
  kServoLate,               ///< the servo loop itself missed its beat
  kFollowingError,          ///< the robot is not where it was told to be
  kInternal,                ///< an exception left the motion loop
  kPoorLine,                ///< the robot's messages come too badly for it to be moved
  kPlannerSilent,           ///< no sign of life from the threads that follow and plan
  kEnablingReleased,        ///< the enabling device was let go during a motion
  kEnablingPressedThrough,  ///< the enabling device was pressed through, as one does in a fright
  kForce,                   ///< the force at the sling reached the limit of the body region
};
inline constexpr int kStopReasonCount = static_cast<int>(StopReason::kForce) + 1;
/// "none", "operator", "camera_silent", ...
[[nodiscard]] std::string_view id(StopReason reason);

}  // namespace mirrorarm::control
