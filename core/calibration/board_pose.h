#pragma once

#include <optional>

#include <Eigen/Core>

#include "core/calibration/board.h"
#include "core/calibration/sighting.h"
#include "core/camera/stereo_rig.h"

namespace mirrorarm::calibration {

/// The board in the left camera, from both images of a calibrated rig.
struct BoardPose {
  RigidTransform X_CM = RigidTransform::Identity();
  Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Zero();  ///< of a SmallMotion of M
  double rms_px = 0.0;  ///< distance of a point from its projection, both images
};

/// By least squares over all points of all images, the discs' centres freed of perspective and lens
/// (vision::physicalCentre). One image with at least 4 points is enough. Nothing below that, or where no pose
/// fits.
[[nodiscard]] std::optional<BoardPose> poseBoard(const camera::StereoRig& rig, const Board& board,
                                                 const BoardView& view);

}  // namespace mirrorarm::calibration
