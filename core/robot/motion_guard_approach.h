#pragma once

#include <optional>

#include "core/robot/motion_guard_check.h"

namespace mirrorarm::robot {

/// The state in which the wish is reached in this very cycle; nothing where the limits of a joint forbid it,
/// or where the arm would not move on there as the wish does and so would have to come back.
[[nodiscard]] std::optional<MotionState> reach(const MotionState& wish, const GuardCheck& check);

/// Accelerations that bring the arm smoothly towards a wish that it cannot reach at once: what is missing
/// gives a speed, what is missing of that an acceleration, each held back by the limits with some room, and
/// so gently at the end that nothing overshoots. Keeps the joints' limits of jerk and acceleration exactly.
struct Approach {
  Joints a_rad_s2;
  GuardVerdict because;  ///< the gravest of the limits that hold it back
};
[[nodiscard]] Approach approach(const MotionState& wish, const GuardCheck& check);

}  // namespace mirrorarm::robot
