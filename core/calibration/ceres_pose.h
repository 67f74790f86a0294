#pragma once

#include <array>
#include <optional>

#include <Eigen/Geometry>

#include "core/geometry/rigid_transform.h"

namespace ceres {
class Problem;
}

namespace mirrorarm::calibration {

/// A pose as the solver moves it: quaternion x, y, z, w, then position [m].
using PoseBlock = std::array<double, 7>;

[[nodiscard]] inline PoseBlock blockOf(const RigidTransform& X) {
  const Eigen::Quaterniond q = rotationOf(X);
  const Eigen::Vector3d p = X.translation();
  return {q.x(), q.y(), q.z(), q.w(), p.x(), p.y(), p.z()};
}

[[nodiscard]] inline RigidTransform poseOf(const PoseBlock& block) {
  return makeTransform(Eigen::Quaterniond(block[3], block[0], block[1], block[2]),
                       Eigen::Vector3d(block[4], block[5], block[6]));
}

/// Tells the solver that the block is a pose; the block outlives the problem.
void addPose(ceres::Problem& problem, PoseBlock& block);

/// A pose inside a residual, of numbers or of dual numbers.
template <class T>
struct PoseIn {
  explicit PoseIn(const T* block) : q(block), p(block + 4) {}
  PoseIn(const Eigen::Quaternion<T>& turn, const Eigen::Matrix<T, 3, 1>& shift) : q(turn), p(shift) {}

  [[nodiscard]] PoseIn operator*(const PoseIn& other) const { return {q * other.q, q * other.p + p}; }
  [[nodiscard]] Eigen::Matrix<T, 3, 1> operator*(const Eigen::Matrix<T, 3, 1>& point) const {
    return q * point + p;
  }
  [[nodiscard]] PoseIn inverse() const {
    const Eigen::Quaternion<T> back = q.conjugate();
    return {back, -(back * p)};
  }

  Eigen::Quaternion<T> q;
  Eigen::Matrix<T, 3, 1> p;
};

/// Covariance of a SmallMotion of the frame that `block` places, from the solved problem. The solver's own
/// turn is half a rotation vector, in the outer frame. Nothing where the problem leaves a freedom.
[[nodiscard]] std::optional<Eigen::Matrix<double, 6, 6>> smallMotionCovariance(ceres::Problem& problem,
                                                                               const PoseBlock& block);

}  // namespace mirrorarm::calibration
