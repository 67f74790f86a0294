#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/tracking/shape_gauge.h"

namespace mirrorarm::tracking {

inline constexpr int kModes = 6;  ///< in which the markers of one target deviate together, at most

using ModeVector = Eigen::Matrix<double, kModes, 1>;
using ModeRows = Eigen::Matrix<double, 3, kModes>;

/// The fields of displacement in which the markers of a target deviate together: principal components of the
/// deviations, about zero, learnt frame by frame with forgetting. Orthonormal; unused ones are zero. Source:
/// Brand, Linear Algebra and its Applications 415, 2006 (the update of a thin decomposition by one column).
class DeviationModes {
 public:
  void resize(std::size_t markers);
  /// Learns from one deviation, which counts `share` of all that is remembered.
  void learn(std::span<const Eigen::Vector3d> deviation, double share);
  /// Takes the rigid part off each mode and makes them orthonormal again.
  void refit(const ShapeGauge& gauge);

  /// Variance of each mode's amplitude [m^2], falling.
  [[nodiscard]] const ModeVector& variances() const { return variances_; }
  [[nodiscard]] const ModeRows& of(std::size_t marker) const { return rows_[marker]; }
  [[nodiscard]] ModeVector amplitudes(std::span<const Eigen::Vector3d> deviation) const;
  /// How the last learn() made new modes of the old ones, a column each.
  [[nodiscard]] const Eigen::Matrix<double, kModes, kModes>& lastTurn() const { return last_turn_; }
  [[nodiscard]] bool areNone() const { return variances_[0] <= 0.0; }

 private:
  using Update = Eigen::Matrix<double, kModes + 1, kModes + 1>;
  void rotate(const Update& covariance, double rest_norm);
  void orthonormalise(int mode);

  std::vector<ModeRows> rows_;
  std::vector<Eigen::Vector3d> rest_;
  ModeVector variances_ = ModeVector::Zero();
  Eigen::Matrix<double, kModes, kModes> last_turn_ = Eigen::Matrix<double, kModes, kModes>::Identity();
};

}  // namespace mirrorarm::tracking
