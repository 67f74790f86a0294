#pragma once

#include <algorithm>
#include <cstdint>
#include <string_view>

#include "core/control/stop_reason.h"

namespace mirrorarm::control {

/// How the robot is stopped, after IEC 60204-1; the graver one is the greater. Category 0, power off at once,
/// belongs to the emergency stop's own wires and never to a program.
enum class StopCategory : std::uint8_t {
  kNone,  ///< not stopped
  kTwo,   ///< braked by commands within the limits; stays driven and watched where it stands
  kOne,   ///< braked by the robot itself, which gives up its drives: see robot::RobotLink::halt
};
/// "none", "2", "1".
[[nodiscard]] std::string_view id(StopCategory category);

/// The category in which a stop for `reason` begins. One where it is in doubt whether the robot is where it
/// was told to be, so that braking by commands could be a jump.
[[nodiscard]] StopCategory categoryOf(StopReason reason) noexcept;

[[nodiscard]] inline StopCategory graver(StopCategory one, StopCategory other) noexcept {
  return std::max(one, other);
}

}  // namespace mirrorarm::control
