#pragma once

#include <optional>

#include <Eigen/Core>

#include "core/camera/stereo_rig.h"
#include "core/vision/detected_marker.h"

namespace mirrorarm::vision {

/// Where a camera images a point and how that moves with the point: d(pixel)/d(p_C), of frame C also for the
/// right camera.
struct PointImage {
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
  camera::CameraModel::ProjectJacobian by_point = camera::CameraModel::ProjectJacobian::Zero();
};

/// A point and both its images.
struct ImagedPoint {
  Eigen::Vector3d p_C = Eigen::Vector3d::Zero();
  PointImage left;
  PointImage right;
};

/// Nothing where a lens model does not hold.
[[nodiscard]] std::optional<ImagedPoint> imaged(const camera::StereoRig& rig, const Eigen::Vector3d& p_C);

/// A centre as measured in one image.
struct MeasuredCentre {
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
  Eigen::Matrix2d weight_px2 = Eigen::Matrix2d::Identity();  ///< inverse covariance [1/px^2]
};
[[nodiscard]] MeasuredCentre measuredCentre(const Eigen::Vector2d& pixel,
                                            const Eigen::Matrix2d& covariance_px2);

/// A point in space from its two images.
struct TriangulatedPoint {
  Eigen::Vector3d p_C = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance_m2 = Eigen::Matrix3d::Zero();
};

/// One step of Gauss and Newton from `near` to the point whose images lie nearest to both centres, weighted:
/// from a pixel away it ends within 1e-3 px of it. Not finite when the two images do not fix a point.
[[nodiscard]] TriangulatedPoint stepTowards(const ImagedPoint& near, const MeasuredCentre& left,
                                            const MeasuredCentre& right);

/// The point of greatest likelihood, from the middle between the two rays. Nothing when the rays run apart,
/// or leave the lens models. Source: Hartley and Zisserman, Multiple View Geometry, 2nd ed., section 12.3.
[[nodiscard]] std::optional<TriangulatedPoint> triangulate(const camera::StereoRig& rig,
                                                           const DetectedMarker& left,
                                                           const DetectedMarker& right);

}  // namespace mirrorarm::vision
