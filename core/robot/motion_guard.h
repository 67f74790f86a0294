#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string_view>

#include "core/robot/joints.h"
#include "core/robot/motion_guard_stop.h"
#include "core/robot/motion_limits.h"
#include "core/robot/trajectory.h"

namespace mirrorarm::robot {

/// Which limit changed a wish, the gravest first.
enum class GuardAction : std::uint8_t {
  kPassed,
  kNotFinite,
  kFollowingError,
  kPosition,
  kCollision,
  kJerk,
  kAcceleration,
  kSpeed,
  kZoneSpeed,
  kToolSpeed,
  kToolAcceleration,
};
/// "passed", "not_finite", ...
[[nodiscard]] std::string_view id(GuardAction action);

/// What was sent last. Speed and acceleration are those of the wire: differences of the positions over the
/// period. `stop` is how the arm comes to rest from here within all limits; empty at rest.
struct Commanded {
  Joints q_rad;
  Joints v_rad_s;
  Joints a_rad_s2;
  Stop stop{};
};
/// At rest there.
[[nodiscard]] Commanded restAt(const Joints& q_rad);
/// Where the arm comes to rest if every wish ended now.
[[nodiscard]] Joints restOf(const Commanded& last, double period_s) noexcept;

/// How near one part of the arm is to another or to an obstacle, and how that changes with the joints.
struct ClearanceRow {
  double distance_m = 0.0;
  double minimum_m = 0.0;  ///< nearer than this the arm must not come
  Joints gradient;         ///< d distance / d joints [m/rad]
  bool at_rest = false;    ///< measured where `restOf(last)` is, not where `last` is
};

/// What the guard knows of the arm besides its joints, all at `last`.
struct Surroundings {
  const Jacobian& jacobian;
  std::span<const ClearanceRow> clearances{};
  double zone_speed_m_s = std::numeric_limits<double>::infinity();  ///< cap on the whole hand near the head
  /// Of points of the hand, as `jacobian` is of the flange's origin: near the head they keep the cap too.
  std::span<const Jacobian> hand{};
  double following_error_rad = 0.0;  ///< commanded against measured
};

struct Guarded {
  Commanded command;
  GuardAction action = GuardAction::kPassed;
  int index = -1;  ///< joint of a joint's limit, row of a collision; -1 where there is none
};

/// Next joint command, given the wish and what was sent last: the last thing before the wire.
///
/// A pure function. A wish within all limits passes unchanged. Any other is approached smoothly, as fast as
/// the limits let it and without overshooting: the wish's speed and acceleration say how it moves on itself.
/// A wish that is not finite, and a robot that is not where it was sent, count as "brake".
///
/// Invariant: every command carries a stop that keeps all limits to its end: joint ranges, speeds,
/// accelerations, jerks, speed and acceleration of the flange's origin, clearances. A step is taken only if
/// it has such a stop; else the nearest to it on the way from the last command's stop that has one, at worst
/// that stop's own next cycle. So from rest within the limits no wish breaks a limit of a joint; those of the
/// flange hold up to the third order of its path, those of clearances up to the second. Going away from a
/// thing or along it is never slowed. From a `last` outside the limits the joints brake or come back, never
/// go further. Does not allocate. Source: docs/adr/0011-motion-guard.md.
[[nodiscard]] Guarded guardMotion(const MotionState& wish, const Commanded& last, const Surroundings& around,
                                  double period_s, const MotionLimits& limits) noexcept;

/// Next command on the shortest way to rest that keeps `limits`: all joints slow down by the same share, so
/// that the flange stays on its path as well as it can. For an emergency give `brakingLimits(limits)`. Does
/// not allocate.
[[nodiscard]] Guarded brakeMotion(const Commanded& last, const Surroundings& around, double period_s,
                                  const MotionLimits& limits) noexcept;

}  // namespace mirrorarm::robot
