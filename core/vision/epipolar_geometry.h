#pragma once

#include <optional>

#include <Eigen/Core>

#include "core/camera/stereo_rig.h"

namespace mirrorarm::vision {

/// A pixel in the rectified image of its camera: no image is resampled, only rays are turned.
struct RectifiedPoint {
  Eigen::Vector2d rectified_px = Eigen::Vector2d::Zero();  ///< at the rig's own focal length, centre at 0
  Eigen::RowVector2d row_by_pixel = Eigen::RowVector2d::Zero();  ///< d(rectified y) / d(raw pixel)
};

/// The frame in which both cameras of a rig look alike: x along the baseline from left to right, z forward.
/// In it a point has the same y in both images and moves left by its disparity in the right one.
class EpipolarGeometry {
 public:
  explicit EpipolarGeometry(const camera::StereoRig& rig);

  /// Nothing where the lens model does not hold, or behind the rectified image.
  [[nodiscard]] std::optional<RectifiedPoint> left(const Eigen::Vector2d& pixel) const;
  [[nodiscard]] std::optional<RectifiedPoint> right(const Eigen::Vector2d& pixel) const;

  /// Distance of the right pixel from the left one's epipolar line, in the raw right image, to first order.
  [[nodiscard]] static double epipolarDistance_px(const RectifiedPoint& left, const RectifiedPoint& right);

  /// The point between both rays, in the left camera [m]; their disparity must be positive.
  [[nodiscard]] Eigen::Vector3d pointOf(const RectifiedPoint& left, const RectifiedPoint& right) const;

 private:
  [[nodiscard]] std::optional<RectifiedPoint> rectify(const camera::CameraModel& camera,
                                                      const Eigen::Matrix3d& R,
                                                      const Eigen::Vector2d& pixel) const;

  camera::CameraModel left_;
  camera::CameraModel right_;
  Eigen::Matrix3d R_EC_;  ///< rectified frame E from the left camera
  Eigen::Matrix3d R_ER_;  ///< and from the right one
  double focal_px_;
  double baseline_m_;
};

}  // namespace mirrorarm::vision
