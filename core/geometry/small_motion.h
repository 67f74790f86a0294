#pragma once

#include <Eigen/Core>

#include "core/geometry/rigid_transform.h"

namespace mirrorarm {

/// A small motion of frame T in itself: turn [rad] then shift [m]. X_CT moved by it is X_CT * exp(d).
using SmallMotion = Eigen::Matrix<double, 6, 1>;

/// The matrix that multiplies as v does in a cross product: crossMatrix(v) * w = v x w.
[[nodiscard]] inline Eigen::Matrix3d crossMatrix(const Eigen::Vector3d& v) {
  Eigen::Matrix3d V;
  V << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return V;
}

/// How a point of T moves with a small motion: its derivative by turn and shift.
[[nodiscard]] inline Eigen::Matrix<double, 3, 6> motionAt(const Eigen::Vector3d& p_T) {
  Eigen::Matrix<double, 3, 6> J;
  J << -crossMatrix(p_T), Eigen::Matrix3d::Identity();
  return J;
}

/// The rotation by a rotation vector (axis times angle [rad]): the inverse of rotationVector().
[[nodiscard]] Eigen::Matrix3d turnBy(const Eigen::Vector3d& rotation_vector);

/// A small motion as a transform: exp(d) to first order of the turn's part in the shift.
[[nodiscard]] RigidTransform smallMotion(const SmallMotion& motion);

/// The pose after a small motion, kept rigid whatever the number of steps.
[[nodiscard]] RigidTransform moved(const RigidTransform& X_CT, const SmallMotion& motion);

}  // namespace mirrorarm
