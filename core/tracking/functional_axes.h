#pragma once

#include <optional>
#include <span>

#include <Eigen/Core>

#include "core/geometry/rigid_transform.h"

namespace mirrorarm::tracking {

/// How one body turns against another: the poses X_PC of a child in its parent.
struct RotationSpread {
  Eigen::Matrix3d mean_R_PC = Eigen::Matrix3d::Identity();
  Eigen::Vector3d axis_P = Eigen::Vector3d::UnitX();  ///< about which it turns most, unit
  double range_rad = 0.0;                             ///< from one end to the other about that axis
  double across_rms_rad = 0.0;  ///< turn about the axis across it that turns most: 0 for a hinge
};

/// The mean helical axis, by the rotation vectors from the mean orientation. At least 2 poses; turns of less
/// than 180 degrees from the mean. Source: Woltring, Human Movement Science 10, 1991; Halvorsen et al.,
/// J. Biomechanics 32, 1999.
[[nodiscard]] RotationSpread rotationSpread(std::span<const RigidTransform> X_PC);

/// A point that both bodies share while they turn about it.
struct RotationCentre {
  Eigen::Vector3d in_P = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Vector3d in_C = Eigen::Vector3d::Zero();
  double rms_m = 0.0;  ///< how far it strays between both
};

/// By least squares of X_PC * in_C - in_P. With `hinge_P`, the axis of a hinge in P, the centre is the point
/// of it nearest to C's mean origin; without, the turns must be about several axes. Nothing when the poses do
/// not fix the point. Source: Gamage and Lasenby, J. Biomechanics 35, 2002.
[[nodiscard]] std::optional<RotationCentre> rotationCentre(
    std::span<const RigidTransform> X_PC, const std::optional<Eigen::Vector3d>& hinge_P = std::nullopt);

}  // namespace mirrorarm::tracking
