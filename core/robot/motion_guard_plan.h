#pragma once

#include <array>

#include "core/robot/motion_guard_check.h"

namespace mirrorarm::robot {

/// The shortest stops from `start` that keep the limits of acceleration and jerk: from the present
/// accelerations straight to the plateau, which suits an arm that brakes already; and with the accelerations
/// brought to zero first, which suits one that gathers speed. Nothing else is looked at.
[[nodiscard]] std::array<Stop, 2> planStops(const MotionState& start, const ToolMotion& tool, double period_s,
                                            const MotionLimits& limits);

}  // namespace mirrorarm::robot
