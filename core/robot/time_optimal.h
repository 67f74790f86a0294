#pragma once

#include <array>

#include "core/robot/speed_change.h"

namespace mirrorarm::robot {

/// A motion of one axis with limited jerk: a speed change, a time at even speed, a speed change.
struct AxisMotion {
  std::array<JerkPiece, 7> pieces{};
  [[nodiscard]] double duration() const noexcept;
};

/// From any state to rest at `goal`, in the shortest time but for starts that brake already and must go on a
/// little further than the brakes would bring them: those pass a moment without acceleration. A start beyond
/// the speed or acceleration limits is led back inside first. Does not allocate. Source: Haschke, Weitnauer,
/// Ritter, IROS 2008; Kröger, On-Line Trajectory Generation in Robotic Systems, 2010.
[[nodiscard]] AxisMotion toRestAt(double goal, const EndState& from, const AxisLimits& limits) noexcept;

}  // namespace mirrorarm::robot
