#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/tracking/excess_variance.h"

namespace mirrorarm::tracking {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;
using RigidRows = Eigen::Matrix<double, 3, 6>;

/// Tells what part of a field of displacements, one a marker, is a motion of the whole body: the rigid motion
/// nearest to it, markers weighted by their stiffness, 1 / (variance of what they have deviated). Weights
/// follow the deviations, and deviations are without a rigid part under the weights: so the part of the skin
/// that moves as one piece comes to carry the frame, and the rest moves against it. A floor of a tenth of the
/// mean variance keeps it from standing on three markers alone.
class ShapeGauge {
 public:
  void resize(std::size_t markers);
  /// Learns how much the markers deviate, present ones only.
  void learn(std::span<const Eigen::Vector3d> deviations, std::span<const char> present,
             double share_of_memory);
  /// Lays the weights on this shape.
  void prepare(std::span<const Eigen::Vector3d> shape_T, std::span<const char> present);

  /// The rigid part of a field, by the last prepare().
  [[nodiscard]] Vector6 rigidPart(std::span<const Eigen::Vector3d> field) const;
  /// Takes it off.
  void removeRigidPart(std::span<Eigen::Vector3d> field) const;
  /// Mean square of a marker's deviation along an axis [m^2].
  [[nodiscard]] double variance(std::size_t marker) const { return squares_[marker].value(); }

 private:
  std::vector<FadingMean> squares_;
  std::vector<double> weights_;
  std::vector<RigidRows> rows_;
  Matrix6 inverse_ = Matrix6::Zero();
};

}  // namespace mirrorarm::tracking
