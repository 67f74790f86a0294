#pragma once

#include <optional>
#include <span>

#include "core/calibration/timed_path.h"

namespace mirrorarm::calibration {

/// Offset and poses that a fit begins with and ends at.
struct ClockFit {
  double offset_s = 0.0;
  RigidTransform X_PC = RigidTransform::Identity();
  RigidTransform X_QM = RigidTransform::Identity();
  double sigma_s = 0.0;  ///< of the offset, by leaving out a tenth of the camera's poses in a row at a time
  Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Zero();  ///< of a SmallMotion of C
  std::vector<StationResidual> residuals;  ///< a camera pose each; outliers have no weight
};

/// Offset, X_PC and X_QM in turn, from near `start`, by robust least squares (Tukey's biweight) over every
/// pose of the camera, the robot's interpolated at camera time plus offset: the poses from all of them, the
/// offset from what changes from one to the next. Camera poses for which the robot has none are not compared.
/// Nothing where the solver fails or fewer than 20 remain.
[[nodiscard]] std::optional<ClockFit> fitClock(const TimedPath& robot, std::span<const TimedPose> camera,
                                               CameraMount mount, const ClockFit& start);

}  // namespace mirrorarm::calibration
