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

/// What was sent last cycle.
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
/// A pure function. Whatever the wish, the result stays finite, within the joint ranges (with room to brake),
/// within the speed and acceleration of `limits` against `last`, and moves no point at the flange faster than
/// the tool speed (`jacobian` at `last`). A wish that is not finite counts as "brake".
/// Does not allocate. Source: Reflexes and command guards as in robot drivers; see docs/adr.
[[nodiscard]] Guarded guardMotion(const Joints& wish_q_rad, const Commanded& last, const Jacobian& jacobian,
                                  double period_s, const MotionLimits& limits) noexcept;

}  // namespace mirrorarm::robot
