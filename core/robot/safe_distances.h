#pragma once

namespace mirrorarm::robot {

/// How near an arm may come to what it must not meet: what the motion guard holds it to and what plans keep.
struct SafeDistances {
  double self_m = 0.010;      ///< to itself
  double obstacle_m = 0.020;  ///< to an obstacle
};
/// Only contact is forbidden.
inline constexpr SafeDistances kTouching{.self_m = 0.0, .obstacle_m = 0.0};

}  // namespace mirrorarm::robot
