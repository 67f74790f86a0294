#pragma once

#include <optional>

#include <Eigen/Core>

#include "core/camera/stereo_rig.h"

namespace mirrorarm::vision {

/// A marker's ray and its point in the rectified image of its camera: no image is resampled, only rays are
/// turned.
struct RectifiedPoint {
  Eigen::Vector3d ray = Eigen::Vector3d::Zero();           ///< unit, in the rectified frame
  Eigen::Vector2d rectified_px = Eigen::Vector2d::Zero();  ///< at the rig's own focal length, centre at 0
};

/// The frame in which both cameras of a rig look alike: x along the baseline from left to right, z forward.
/// In it a point has the same y in both images and moves left by its disparity in the right one.
class EpipolarGeometry {
 public:
  explicit EpipolarGeometry(const camera::StereoRig& rig);

  /// Nothing where the lens model does not hold, or behind the rectified image.
  [[nodiscard]] std::optional<RectifiedPoint> left(const Eigen::Vector2d& pixel) const;
  [[nodiscard]] std::optional<RectifiedPoint> right(const Eigen::Vector2d& pixel) const;

  /// Distance of the right ray from the epipolar plane of the left one, as pixels in the middle of the image.
  [[nodiscard]] double epipolarDistance_px(const RectifiedPoint& left, const RectifiedPoint& right) const;

 private:
  [[nodiscard]] std::optional<RectifiedPoint> rectify(const camera::CameraModel& camera,
                                                      const Eigen::Matrix3d& R,
                                                      const Eigen::Vector2d& pixel) const;

  camera::CameraModel left_;
  camera::CameraModel right_;
  Eigen::Matrix3d R_EC_;  ///< rectified frame E from the left camera
  Eigen::Matrix3d R_ER_;  ///< and from the right one
  double focal_px_;
};

}  // namespace mirrorarm::vision
