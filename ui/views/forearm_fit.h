#pragma once

#include <span>

#include <Eigen/Core>

#include "core/geometry/rigid_transform.h"

namespace mirrorarm::ui {

/// A forearm as markers on its skin or sleeve suggest it.
struct ForearmFit {
  RigidTransform X_TA = RigidTransform::Identity();  ///< axis of the forearm in the target: z along it, the
                                                     ///< origin amid the markers
  double radius_m = 0.0;                             ///< from the axis to the markers, 0.02 to 0.07
  double half_length_m = 0.0;                        ///< of the part that carries markers
};

/// Lays a cylinder through the markers of a target: its axis along their greatest extent, its radius by a
/// circle across. For drawing; needs at least 3 markers. `towards_camera_T` tells on which side they can be
/// seen.
[[nodiscard]] ForearmFit fitForearm(std::span<const Eigen::Vector3d> markers_T,
                                    const Eigen::Vector3d& towards_camera_T);

}  // namespace mirrorarm::ui
