#pragma once

#include <Eigen/LU>

#include "core/geometry/rigid_transform.h"

namespace mirrorarm::benchmarks::tracking {

/// Squared error of a pose in units of its own covariance, e' C^-1 e: 6 on average when that is honest.
/// `Pose` has X_CT and the covariance of a small motion in T, turn then shift.
template <class Pose>
[[nodiscard]] double squaredSigmas(const Pose& pose, const RigidTransform& X_CT_true) {
  const RigidTransform d = pose.X_CT.inverse() * X_CT_true;
  Eigen::Matrix<double, 6, 1> error;
  error << rotationVector(d.linear()), d.translation();
  return error.dot(pose.covariance.inverse() * error);
}

}  // namespace mirrorarm::benchmarks::tracking
