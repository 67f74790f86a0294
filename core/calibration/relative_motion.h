#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/calibration/pose_pairs.h"

namespace mirrorarm::calibration {

/// How the robot turned between two stations, i < j.
struct RelativeMotion {
  std::size_t i = 0;
  std::size_t j = 0;
  RigidTransform A = RigidTransform::Identity();  ///< X_FjFi, of the robot
  RigidTransform B = RigidTransform::Identity();  ///< X_CjCi, of the camera, so that A X_FC = X_FC B
  double weight = 1.0;
};

/// Between every two stations.
[[nodiscard]] std::vector<RelativeMotion> relativeMotions(std::span<const PosePair> pairs);

/// Those that say something about X_FC: turned by at least half of what the median one does, and not by
/// nearly half a turn, whose axis has no sign. `weights`: one a station, >= 0; empty for equal ones.
[[nodiscard]] std::vector<RelativeMotion> tellingMotions(std::span<const PosePair> pairs,
                                                         std::span<const double> weights = {});

/// Position of the camera once its rotation is known: least squares of (R_A - I) p = R_FC p_B - p_A. Nothing
/// when the turns do not fix it.
[[nodiscard]] std::optional<Eigen::Vector3d> positionOverMotions(std::span<const RelativeMotion> motions,
                                                                 const Eigen::Matrix3d& R_FC);

}  // namespace mirrorarm::calibration
