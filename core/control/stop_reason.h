#pragma once

#include <cstdint>
#include <string_view>

namespace mirrorarm::control {

/// Why the robot was brought to rest. A stop is latched until it is reset; resetting never starts a motion.
enum class StopReason : std::uint8_t {
  kNone,
  kOperator,        ///< somebody pressed STOP
  kCameraSilent,    ///< no frame for too long
  kTargetLost,      ///< frames come, the target does not
  kRobotSilent,     ///< the robot does not answer
  kRobotFault,      ///< the robot says that it cannot move
  kServoLate,       ///< the servo loop itself missed its beat
  kFollowingError,  ///< the robot is not where it was told to be
  kInternal,        ///< an exception left the motion loop
};
/// "none", "operator", "camera_silent", ...
[[nodiscard]] std::string_view id(StopReason reason);

}  // namespace mirrorarm::control
