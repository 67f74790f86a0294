#pragma once

#include <Eigen/Core>

#include "core/common/time.h"
#include "core/geometry/rigid_transform.h"
#include "core/tracking/motion_filter.h"

namespace mirrorarm::tracking {

/// A pose with its covariance: turn [rad] then shift [m], as a small motion in T.
struct UncertainPose {
  RigidTransform X_CT = RigidTransform::Identity();
  Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Zero();
};

/// Where a target is at any time after its last measured poses, with how sure that is.
///
/// The shift of T's origin in C and the turn of T since the last pose are followed by a MotionFilter each:
/// models of rest, glide and swing, weighed by how well they foretold the last poses. So a limb that stops is
/// held from the second pose of 24 Hz at rest on, without a swing back. The covariance grows with the time
/// ahead and with the speed; on smooth motions it is conservative, and a sudden stop is allowed for, once in
/// some seconds. Frames may be lost or come at any times; after half a second without a pose it starts anew.
/// Fixed size; no heap; one thread.
class MotionPredictor {
 public:
  /// A new measured pose with its covariance. A time not after the last one replaces it, and what was known
  /// about the motion is forgotten.
  void add(TimePoint time, const UncertainPose& pose);
  /// From now on the motion is that of a frame which lies elsewhere on the body: at `time`, where at() was
  /// expected, it is at `X_CT`; it moves as before. So a shape that is taught anew is no jump of the arm.
  void moveTo(TimePoint time, const RigidTransform& X_CT);
  void forget() { known_ = false; }

  [[nodiscard]] bool isKnown() const { return known_; }
  [[nodiscard]] TimePoint lastMeasured() const { return last_; }
  /// Since the last measured pose; never negative.
  [[nodiscard]] Seconds ageAt(TimePoint time) const;
  /// The pose at `time`, later than the last measured one or a little (one frame) before it. At the time of
  /// the last measured pose it is the filtered one. Needs isKnown().
  [[nodiscard]] UncertainPose at(TimePoint time) const;

 private:
  /// A turn of so many radians does to a forearm's far end what a metre does to all of it.
  static constexpr double kTurnOfAMetre_rad = 5.0;

  bool known_ = false;
  TimePoint last_{};
  Eigen::Matrix3d R_CT_ = Eigen::Matrix3d::Identity();  ///< of the last pose, filtered: turns count from it
  MotionFilter shift_{1.0};                             ///< T's origin in C [m]
  MotionFilter turn_{kTurnOfAMetre_rad};                ///< rotation vector from R_CT_, in T [rad]
};

}  // namespace mirrorarm::tracking
