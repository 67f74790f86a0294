#include "core/tracking/shape_gauge.h"

#include <algorithm>

#include <Eigen/LU>

#include "core/geometry/small_motion.h"

namespace mirrorarm::tracking {

void ShapeGauge::resize(std::size_t markers) {
  squares_.resize(markers);
  weights_.resize(markers, 0.0);
  rows_.resize(markers, RigidRows::Zero());
}

void ShapeGauge::learn(std::span<const Eigen::Vector3d> deviations, std::span<const char> present,
                       double share_of_memory) {
  for (std::size_t i = 0; i < squares_.size(); ++i)
    if (present[i] != 0) squares_[i].add(deviations[i].squaredNorm() / 3.0, share_of_memory);
}

void ShapeGauge::prepare(std::span<const Eigen::Vector3d> shape_T, std::span<const char> present) {
  Matrix6 normal = Matrix6::Zero();
  for (std::size_t i = 0; i < squares_.size(); ++i) {
    weights_[i] = present[i] != 0 ? 1.0 : 0.0;
    rows_[i] = motionAt(shape_T[i]);
    normal += weights_[i] * rows_[i].transpose() * rows_[i];
  }
  inverse_ = normal.inverse();
}

Vector6 ShapeGauge::rigidPart(std::span<const Eigen::Vector3d> field) const {
  Vector6 right = Vector6::Zero();
  for (std::size_t i = 0; i < rows_.size(); ++i) right += weights_[i] * rows_[i].transpose() * field[i];
  return inverse_ * right;
}

void ShapeGauge::removeRigidPart(std::span<Eigen::Vector3d> field) const {
  const Vector6 motion = rigidPart(field);
  for (std::size_t i = 0; i < rows_.size(); ++i) field[i] -= rows_[i] * motion;
}

}  // namespace mirrorarm::tracking
