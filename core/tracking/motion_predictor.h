#pragma once

#include <Eigen/Core>

#include "core/common/time.h"
#include "core/geometry/rigid_transform.h"

namespace mirrorarm::tracking {

/// A pose with its covariance: turn [rad] then shift [m], as a small motion in T.
struct UncertainPose {
  RigidTransform X_CT = RigidTransform::Identity();
  Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Zero();
};

/// Where a target is at any time after its last measured poses, with how sure that is. Fixed size; no heap;
/// one thread.
class MotionPredictor {
 public:
  /// A new measured pose. A time not after the last one replaces it.
  void add(TimePoint time, const UncertainPose& pose);
  void forget();

  [[nodiscard]] bool isKnown() const;
  [[nodiscard]] TimePoint lastMeasured() const;
  /// Since the last measured pose; never negative.
  [[nodiscard]] Seconds ageAt(TimePoint time) const;
  /// The pose at `time`, later than the last measured one or a little (one frame) before it.
  [[nodiscard]] UncertainPose at(TimePoint time) const;
};

}  // namespace mirrorarm::tracking
