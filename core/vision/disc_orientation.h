#pragma once

#include <optional>

#include <Eigen/Core>

#include "core/vision/detected_marker.h"
#include "core/vision/triangulation.h"

namespace mirrorarm::vision {

/// How a flat disc lies in space, and how well both its outlines agree with that.
struct DiscOrientation {
  Eigen::Vector3d normal_C = Eigen::Vector3d::Zero();  ///< unit, towards the cameras
  double radius_m = 0.0;
  /// Of radius_m * normal_C. Where noise alone decides between a normal and its mirror image, both are in it.
  Eigen::Matrix3d covariance_m2 = Eigen::Matrix3d::Zero();
  /// Chi squared with 3 degrees of freedom: two outlines have six numbers. Outlines that no disc can have
  /// are not followed to the end: then it is in the hundreds and the rest a first guess.
  double misfit = 0.0;
};

/// The disc at `images` whose projections match the outlines of both markers best, weighted by their shape
/// covariances and what the model leaves out: each image's affine map takes r^2 (I - n n^T) to the outline's
/// shape matrix. One outline leaves two mirrored normals; both together leave one, but for noise. Nothing
/// when an outline is no ellipse.
[[nodiscard]] std::optional<DiscOrientation> discOrientation(const ImagedPoint& images,
                                                             const DetectedMarker& left,
                                                             const DetectedMarker& right);

}  // namespace mirrorarm::vision
