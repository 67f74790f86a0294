#pragma once

#include <optional>

#include <Eigen/Core>

#include "core/camera/camera_model.h"

namespace mirrorarm::vision {

/// A flat round disc in the frame of camera K.
struct FlatDisc {
  Eigen::Vector3d p_K = Eigen::Vector3d::Zero();  ///< its centre [m]
  Eigen::Vector3d normal_K = -Eigen::Vector3d::UnitZ();
  double radius_m = 0.0;
};

/// How far the centre of the ellipse that fits the disc's raw outline best (least squares of the distances
/// along the outline) lies from the image of the disc's own centre [px]: perspective makes the nearer half
/// larger, and a lens bends the outline. Hundredths of a pixel for a 7 mm disc at 0.4 m, tenths at the border
/// of a wide pinhole image. Right to 0.001 px for such discs from 0.25 m on, tilted up to 60 degrees. Nothing
/// where the lens model does not hold. Source of the effect: Ahn, Warnecke, Kotowski, Systematic geometric
/// image measurement errors of circular object targets, Photogrammetric Record 16(93), 1999.
[[nodiscard]] std::optional<Eigen::Vector2d> centreBias(const camera::CameraModel& camera,
                                                        const FlatDisc& disc);
/// The same for who knows the image of the disc's centre already.
[[nodiscard]] std::optional<Eigen::Vector2d> centreBias(const camera::CameraModel& camera,
                                                        const FlatDisc& disc,
                                                        const Eigen::Vector2d& centre_px);

/// The image of the disc's centre, from the centre that a fit found in the raw image; the disc may come from
/// two views or from a tracked pose. As fitted where the lens model does not hold.
[[nodiscard]] Eigen::Vector2d physicalCentre(const camera::CameraModel& camera,
                                             const Eigen::Vector2d& fitted_px, const FlatDisc& disc);

}  // namespace mirrorarm::vision
