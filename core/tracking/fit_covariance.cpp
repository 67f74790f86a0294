#include "core/tracking/fit_covariance.h"

#include <algorithm>
#include <cassert>

#include <Eigen/LU>

#include "core/geometry/small_motion.h"

namespace mirrorarm::tracking {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

/// Variance of one coordinate that the misfit shows beyond the sensors' own.
double deformationVariance(const RigidTransform& X_CT, std::span<const Vector3d> markers_T,
                           std::span<const Vector3d> points_C, std::span<const Matrix3d> covariances_C_m2) {
  double misfit = 0.0, sensor = 0.0;
  for (std::size_t i = 0; i < markers_T.size(); ++i) {
    misfit += (points_C[i] - X_CT * markers_T[i]).squaredNorm();
    sensor += covariances_C_m2[i].trace();
  }
  const auto coordinates = static_cast<double>(3 * markers_T.size());
  return std::max(0.0, misfit / (coordinates - 6.0) - sensor / coordinates);
}

}  // namespace

Matrix6d fitCovariance(const RigidTransform& X_CT, std::span<const Vector3d> markers_T,
                       std::span<const Vector3d> points_C, std::span<const Matrix3d> covariances_C_m2) {
  assert(markers_T.size() >= 3 && markers_T.size() == points_C.size());
  assert(markers_T.size() == covariances_C_m2.size());
  const double deformation = deformationVariance(X_CT, markers_T, points_C, covariances_C_m2);
  const Matrix3d R_CT = X_CT.linear();
  Matrix6d normal = Matrix6d::Zero(), spread = Matrix6d::Zero();
  for (std::size_t i = 0; i < markers_T.size(); ++i) {
    const Eigen::Matrix<double, 3, 6> J = motionAt(markers_T[i]);
    const Matrix3d covariance_T =
        R_CT.transpose() * covariances_C_m2[i] * R_CT + deformation * Matrix3d::Identity();
    normal += J.transpose() * J;
    spread += J.transpose() * covariance_T * J;
  }
  const Matrix6d inverse = normal.inverse();
  const Matrix6d covariance = inverse * spread * inverse.transpose();
  return 0.5 * (covariance + covariance.transpose());
}

}  // namespace mirrorarm::tracking
