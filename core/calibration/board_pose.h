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
  /// Of a SmallMotion of M. From the points' own standard deviations where all are known, or larger when the
  /// misfit says so; else from the misfit.
  Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Zero();
  double rms_px = 0.0;  ///< distance of a point from its projection, both images
  BoardView centres;    ///< the view with every disc's outline centre replaced by its physical centre
};

/// By least squares over all points of all images, the discs' centres freed of perspective and lens
/// (vision::physicalCentre). One image with at least 4 points is enough; for a single camera only `left` of
/// the rig counts. Nothing below that, for points on a line, or where no pose fits. A millisecond or less.
[[nodiscard]] std::optional<BoardPose> poseBoard(const camera::StereoRig& rig, const Board& board,
                                                 const BoardView& view);

}  // namespace mirrorarm::calibration
