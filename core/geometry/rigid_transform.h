#pragma once

#include <array>

#include <Eigen/Geometry>

namespace mirrorarm {

/// Pose of frame B in frame A, named X_AB at every use: p_A = X_AB * p_B. Metres.
using RigidTransform = Eigen::Isometry3d;

/// The pose with rotation `R_AB` (a rotation matrix) and origin `p_AB` [m].
[[nodiscard]] RigidTransform makeTransform(const Eigen::Matrix3d& R_AB, const Eigen::Vector3d& p_AB);

/// The same from a quaternion, which is normalised; it must not be zero.
[[nodiscard]] RigidTransform makeTransform(const Eigen::Quaterniond& q_AB, const Eigen::Vector3d& p_AB);

/// Rotation as a unit quaternion with w >= 0, so that equal rotations print alike.
[[nodiscard]] Eigen::Quaterniond rotationOf(const RigidTransform& X_AB);

/// Angle between two orientations [rad], 0..pi.
[[nodiscard]] double angleBetween(const RigidTransform& X_AB, const RigidTransform& X_AC);

/// Between two poses, `share` 0 gives `from` and 1 gives `to`: straight line and shortest turn at even speed.
[[nodiscard]] RigidTransform interpolate(const RigidTransform& from, const RigidTransform& to, double share);

/// Rotation vector (axis times angle, angle <= pi) of a rotation matrix.
[[nodiscard]] Eigen::Vector3d rotationVector(const Eigen::Matrix3d& R);

/// True when every number is finite and the rotation is orthonormal with determinant +1 to `tolerance`.
[[nodiscard]] bool isRigid(const RigidTransform& X, double tolerance = 1e-6);

}  // namespace mirrorarm
