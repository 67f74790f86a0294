#pragma once

#include <span>

#include <Eigen/Core>

#include "core/geometry/rigid_transform.h"

namespace mirrorarm {

/// Mean of the points, at least 1.
[[nodiscard]] Eigen::Vector3d centroid(std::span<const Eigen::Vector3d> points);

/// The pose X with the least sum of |y - X x|^2, by singular values (Kabsch 1976, Umeyama 1991 without
/// scale). Spans of equal length, at least 1 point; below 3 points not on a line the rotation is one of many.
[[nodiscard]] RigidTransform fitByKabsch(std::span<const Eigen::Vector3d> x,
                                         std::span<const Eigen::Vector3d> y);

/// Root mean square of |y - X x| [m]. Spans of equal length, at least 1 point.
[[nodiscard]] double fitRms(const RigidTransform& X, std::span<const Eigen::Vector3d> x,
                            std::span<const Eigen::Vector3d> y);

}  // namespace mirrorarm
