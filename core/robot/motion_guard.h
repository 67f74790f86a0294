#pragma once

#include <cstdint>
#include <string_view>

#include "core/robot/joints.h"
#include "core/robot/motion_limits.h"

namespace mirrorarm::robot {

/// Which limit changed a wish.
enum class GuardAction : std::uint8_t { kPassed, kNotFinite, kPosition, kSpeed, kAcceleration, kToolSpeed };
/// "passed", "not_finite", ...
[[nodiscard]] std::string_view id(GuardAction action);

/// A joint command and its speed. As "what was sent last": the speed is the step of the last cycle over the
/// period.
struct Commanded {
  Joints q_rad;
  Joints v_rad_s;
};

struct Guarded {
  Commanded command;
  GuardAction action = GuardAction::kPassed;
};

/// Next joint command, given the wish and what was sent last: the last thing before the wire.
///
/// A pure function. A wish within all limits passes unchanged. Any other is approached as fast as the limits
/// let it, without overshooting: `wish.v_rad_s` says how fast the wish itself moves at its position. A wish
/// that is not finite counts as "brake". Where limits contradict each other the earlier one wins:
/// 1. the result is finite; 2. the acceleration of each joint against `last`; 3. the joint ranges, with room
/// to brake, so that 2 and 3 never contradict from a `last` that keeps them; 4. the joint speeds; 5. speed
/// and acceleration of the flange's origin (`jacobian` at `last`). 5 gives way when a joint must brake for
/// its range. From a `last` outside the limits the joints brake or come back, never go further. Does not
/// allocate. Source: command guards of robot drivers; docs/adr/0003-speed-limits.md.
[[nodiscard]] Guarded guardMotion(const Commanded& wish, const Commanded& last, const Jacobian& jacobian,
                                  double period_s, const MotionLimits& limits) noexcept;

/// Next command on the shortest way to rest along the present direction: all joints slow down by the same
/// share, so that the flange stays on its path as well as it can. The same limits hold. Does not allocate.
[[nodiscard]] Guarded brakeMotion(const Commanded& last, const Jacobian& jacobian, double period_s,
                                  const MotionLimits& limits) noexcept;

}  // namespace mirrorarm::robot
