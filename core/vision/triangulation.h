#pragma once

#include <optional>

#include <Eigen/Core>

#include "core/camera/stereo_rig.h"
#include "core/vision/detected_marker.h"

namespace mirrorarm::vision {

/// A point in space from its two images.
struct TriangulatedPoint {
  Eigen::Vector3d p_C = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance_m2 = Eigen::Matrix3d::Zero();
};

/// The point whose raw pixels lie nearest to both centres, weighted by their covariances, by Gauss-Newton
/// from the middle between the two rays. Nothing when the rays run apart, or leave the lens models. Source:
/// Hartley and Zisserman, Multiple View Geometry, 2nd ed., section 12.3.
[[nodiscard]] std::optional<TriangulatedPoint> triangulate(const camera::StereoRig& rig,
                                                           const DetectedMarker& left,
                                                           const DetectedMarker& right);

}  // namespace mirrorarm::vision
