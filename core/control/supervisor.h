#pragma once

#include <cstdint>
#include <string_view>

#include "core/common/time.h"
#include "core/control/enabling_switch.h"
#include "core/control/force_watch.h"
#include "core/control/stop_category.h"
#include "core/control/stop_reason.h"
#include "core/robot/robot_link.h"

namespace mirrorarm::control {

/// docs/safety.md lists each with its reaction and its test.
struct SupervisorSettings {
  Seconds hold_after{0.100};           ///< target older than this: the robot holds where it is
  Seconds stop_after{0.250};           ///< target older than this while following: stop
  Seconds camera_silent_after{0.250};  ///< newest frame older than this while following: stop
  Seconds planner_silent_after{0.150};
  Seconds drives_off_after{1.0};  ///< silence of camera, target or planner that outlasts this: category 1
  Seconds robot_silent_after{0.050};
  Seconds servo_late_after{0.100};
  Seconds braking_time{1.0};  ///< braking by commands that takes longer than this: category 1
  double max_following_error_rad = 0.10;
  double max_deflection_rad = 0.50;   ///< the same where the robot gives way to forces
  double max_start_error_rad = 0.02;  ///< a motion that starts further away than this is refused
  Seconds soft_start{1.0};            ///< until the full speed is allowed after a start or a hold
  bool enabling_needed = false;       ///< motion only while the enabling device is held
  Seconds enabling_silent_after{0.25};
};

/// What the supervisor looks at, once a servo cycle.
struct Vitals {
  TimePoint now{};
  TimePoint last_frame{};     ///< exposure of the newest frame
  TimePoint last_target{};    ///< exposure of the newest frame in which the target was tracked
  TimePoint last_decision{};  ///< newest sign of life from the planning thread
  TimePoint last_robot{};     ///< newest state of the robot
  TimePoint last_cycle{};     ///< servo cycle before this one
  robot::LinkFault fault = robot::LinkFault::kNone;  ///< of this cycle's reading
  double following_error_rad = 0.0;                  ///< largest joint difference, commanded to measured
  bool gives_way = false;                            ///< the robot is set to give way to forces
  bool following = false;                            ///< the robot follows the target now
  bool moving = false;                               ///< it is in motion, or has one to do
  EnablingPosition enabling = EnablingPosition::kReleased;
  ForceLevel force = ForceLevel::kCalm;
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

/// The watchdogs, in this order: robot, operator, force, and while following planner, camera and target. A
/// pure function, like all here: the latch lives in the servo loop. Does not allocate.
[[nodiscard]] Verdict supervise(const Vitals& vitals, const SupervisorSettings& settings) noexcept;

/// A latched stop under way.
struct Stop {
  StopReason reason = StopReason::kNone;  ///< the first one
  StopCategory category = StopCategory::kNone;
  TimePoint since{};
};

/// The category from now on; it never becomes milder. `trouble` is what the watchdogs say now: a robot may
/// fail while it is being stopped for another reason.
[[nodiscard]] StopCategory categoryNow(const Stop& stop, StopReason trouble, bool at_rest,
                                       const Vitals& vitals, const SupervisorSettings& settings) noexcept;

/// What would stop the robot again at once if the stop were reset now; kNone when the cause is gone.
[[nodiscard]] StopReason lastingCause(const Stop& stop, StopReason trouble, const Vitals& vitals,
                                      const SupervisorSettings& settings) noexcept;

}  // namespace mirrorarm::control
