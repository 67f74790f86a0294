#pragma once

#include <array>

#include "core/robot/polynomial.h"

namespace mirrorarm::robot {

/// What one axis may do. The speeds need not be symmetric: an axis that is looked at from a moving frame has
/// less room ahead than behind. `least_speed` < 0 < `most_speed`.
struct AxisLimits {
  double least_speed = 0.0;
  double most_speed = 0.0;
  double acceleration = 0.0;
  double jerk = 0.0;
};

/// For `duration_s` the acceleration changes by `jerk` a second.
struct JerkPiece {
  double duration_s = 0.0;
  double jerk = 0.0;
};

/// From one speed to another without acceleration, as fast as acceleration and jerk allow: the acceleration
/// ramps up, stays, ramps down. Some of the pieces may last no time.
using SpeedChange = std::array<JerkPiece, 3>;

/// The fastest change from speed and acceleration of `from` to `speed` with no acceleration. An acceleration
/// beyond the limit is led back to it first. Source: Haschke, Weitnauer, Ritter, IROS 2008, section III.
[[nodiscard]] SpeedChange changeSpeed(const EndState& from, double speed, const AxisLimits& limits) noexcept;

/// The state when `piece` is over.
[[nodiscard]] EndState after(const EndState& from, const JerkPiece& piece) noexcept;

/// The speed that the axis gets when its acceleration is taken to zero at once.
[[nodiscard]] double coastingSpeed(const EndState& from, double jerk) noexcept;

}  // namespace mirrorarm::robot
