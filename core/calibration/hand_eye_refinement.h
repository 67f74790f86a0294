#pragma once

#include <optional>
#include <span>

#include <Eigen/Core>

#include "core/calibration/pose_pairs.h"

namespace mirrorarm::calibration {

/// X_FC and X_BM of greatest likelihood, and how sure.
struct RefinedPoses {
  RigidTransform X_FC = RigidTransform::Identity();
  RigidTransform X_BM = RigidTransform::Identity();
  double sigma_m = 0.0;    ///< noise of one station's object in the camera, each axis, as the residuals tell
  double sigma_rad = 0.0;  ///< and of its rotation
  Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Zero();  ///< of a SmallMotion of C
};

/// From near `X_FC` to the poses with the least robust sum of squares of how far each station's object lies
/// from where X_FC and X_BM put it in the camera: shifts and turns, each in units of its noise, which is
/// estimated in turn. At least 3 stations turned about two axes. Nothing where the solver fails.
[[nodiscard]] std::optional<RefinedPoses> refinePoses(std::span<const PosePair> pairs,
                                                      const RigidTransform& X_FC);

}  // namespace mirrorarm::calibration
