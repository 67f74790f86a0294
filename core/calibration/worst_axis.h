#pragma once

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

namespace mirrorarm::calibration {

/// Standard deviation along the axis where a position is least certain [m].
[[nodiscard]] inline double worstAxisSigma(const Eigen::Matrix3d& covariance_m2) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(covariance_m2, Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(0.0, axes.eigenvalues()[2]));
}

}  // namespace mirrorarm::calibration
