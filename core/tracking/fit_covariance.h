#pragma once

#include <span>

#include <Eigen/Core>

#include "core/geometry/rigid_transform.h"

namespace mirrorarm::tracking {

/// Covariance of a least-squares pose X_CT over pairs of markers in T and points in C: turn [rad] then shift
/// [m], as a small motion in T (X_CT * exp(d)). The points carry their sensor covariances; what the misfit
/// shows beyond them (deformation) is added as equal variance in all directions. Spans of equal length, at
/// least 3 pairs not on a line.
[[nodiscard]] Eigen::Matrix<double, 6, 6> fitCovariance(const RigidTransform& X_CT,
                                                        std::span<const Eigen::Vector3d> markers_T,
                                                        std::span<const Eigen::Vector3d> points_C,
                                                        std::span<const Eigen::Matrix3d> covariances_C_m2);

}  // namespace mirrorarm::tracking
