#pragma once

#include <Eigen/Core>

#include "core/camera/stereo_rig.h"

namespace mirrorarm::camera {

/// True when a point's image lies inside both sensors, `margin_px` from their borders. What stands in between
/// and what a marker sends back is not asked.
[[nodiscard]] bool bothCamerasSee(const StereoRig& rig, const Eigen::Vector3d& p_C, double margin_px = 0.0);

}  // namespace mirrorarm::camera
