#pragma once

#include <optional>

#include <Eigen/Core>

#include "core/camera/camera_model.h"

namespace mirrorarm::vision {

/// The plane in which one disc's outline is fitted: perpendicular to the ray through the disc, so that a disc
/// is an ellipse there whatever the lens, with one unit a pixel at the disc. Without a camera the image
/// itself.
class FitPlane {
 public:
  /// Nothing where the lens model does not hold. `camera` may be null and must outlive the plane.
  [[nodiscard]] static std::optional<FitPlane> around(const camera::CameraModel* camera,
                                                      const Eigen::Vector2d& pixel);

  [[nodiscard]] std::optional<Eigen::Vector2d> fromPixel(const Eigen::Vector2d& pixel) const;
  /// The pixel of a point and d(pixel)/d(point).
  [[nodiscard]] std::optional<Eigen::Vector2d> toPixel(const Eigen::Vector2d& point,
                                                       Eigen::Matrix2d& J) const;

 private:
  const camera::CameraModel* camera_ = nullptr;
  Eigen::Matrix3d R_PC_ = Eigen::Matrix3d::Identity();  ///< plane frame P: z along the ray through the disc
  double scale_px_ = 1.0;
};

}  // namespace mirrorarm::vision
