#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/calibration/sighting.h"
#include "core/camera/camera_model.h"
#include "core/geometry/rigid_transform.h"

namespace mirrorarm::calibration {

/// Poses X_CM of a flat board that one image allows, the better first: the outline of a small or far board
/// looks nearly the same from either side of the line of sight. A start for refinement, to some tenths of a
/// degree. Empty for fewer than 4 points within the lens model's range, or points on a line. `board` lies in
/// z = 0. Source: Collins and Bartoli, Infinitesimal plane-based pose estimation, IJCV 109(3), 2014.
[[nodiscard]] std::vector<RigidTransform> planarPoses(const camera::CameraModel& camera,
                                                      std::span<const Eigen::Vector3d> board,
                                                      const Sighting& sighting);

}  // namespace mirrorarm::calibration
