#pragma once

#include <functional>
#include <string>
#include <vector>

#include "benchmarks/trial_random.h"
#include "core/geometry/rigid_transform.h"

namespace mirrorarm::benchmarks::tracking {

/// A limb's motion of half a second and more, judged from `judged_from_s` to `judged_to_s`.
struct LimbMotion {
  std::function<RigidTransform(double)> at;  ///< pose in the camera at a time [s]
  double judged_from_s = 0.5;
  double judged_to_s = 1.5;
};

/// A kind of motion; each trial starts it elsewhere.
struct LimbMotionKind {
  std::string name;
  LimbMotion (*make)(TrialRandom& random);
  bool stops = false;
};

/// Swings of 0.55, 0.7, 0.85 and 1.2 Hz, minimum-jerk reaches, a sudden and a smooth stop, rest. All turn by
/// a radian for each 300 mm.
[[nodiscard]] const std::vector<LimbMotionKind>& limbMotions();

}  // namespace mirrorarm::benchmarks::tracking
