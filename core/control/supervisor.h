#pragma once

#include <cstdint>
#include <string_view>

#include "core/common/time.h"
#include "core/control/stop_reason.h"

namespace mirrorarm::control {

struct SupervisorSettings {
  Seconds hold_after{0.100};  ///< target older than this: the robot holds where it is
  Seconds stop_after{0.250};  ///< target older than this while following: stop
  Seconds camera_silent_after{0.250};
  Seconds robot_silent_after{0.050};
  Seconds servo_late_after{0.100};
  double max_following_error_rad = 0.10;
};

/// What the supervisor looks at, once a servo cycle.
struct Vitals {
  TimePoint now{};
  TimePoint last_frame{};            ///< exposure of the newest frame
  TimePoint last_target{};           ///< exposure of the newest frame in which the target was tracked
  TimePoint last_robot{};            ///< newest state of the robot
  TimePoint last_cycle{};            ///< servo cycle before this one
  double following_error_rad = 0.0;  ///< largest joint difference, commanded to measured
  bool following = false;            ///< the robot follows the target now
};

/// What it allows.
enum class Permit : std::uint8_t {
  kMove,
  kHold,  ///< brake and wait; goes on by itself when the target is back
  kStop,  ///< latched
};

/// "move", "hold", "stop".
[[nodiscard]] std::string_view id(Permit permit);

struct Verdict {
  Permit permit = Permit::kMove;
  StopReason reason = StopReason::kNone;
};

/// The watchdogs, the robot's before the target's; those of frames and target watch only while following. A
/// pure function: the latch lives in the servo loop. Does not allocate.
[[nodiscard]] Verdict supervise(const Vitals& vitals, const SupervisorSettings& settings) noexcept;

}  // namespace mirrorarm::control
