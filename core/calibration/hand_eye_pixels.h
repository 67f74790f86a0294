#pragma once

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/calibration/board_hand_eye.h"

namespace mirrorarm::calibration {

/// What is fitted, all boards the right way round and free of contradicting stations.
struct PixelProblem {
  const camera::StereoRig& rig;
  std::span<const Eigen::Vector3d> points;  ///< of the board
  std::vector<HandEyeStation> stations;
  CameraMount mount = CameraMount::kInHand;
  RobotNoise robot;
  double sigma_px = 0.0;  ///< of a point along either axis
};

struct PixelStart {
  RigidTransform X_PC = RigidTransform::Identity();
  RigidTransform X_QM = RigidTransform::Identity();
};

struct PixelFit {
  RigidTransform X_PC = RigidTransform::Identity();
  RigidTransform X_QM = RigidTransform::Identity();
  double scale = 1.0;  ///< of the board
  double scale_sigma = 0.0;
  Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Zero();  ///< of a SmallMotion of C
  double rms_px = 0.0;
  std::vector<double> stations_px;
};

/// Least squares over all pixels, the flange free at every station within the robot's noise; with the scale
/// of the board free or 1. Covariances grow with the misfit where it is beyond the noise. Nothing where the
/// solver fails or a point leaves a lens model.
[[nodiscard]] std::optional<PixelFit> fitPixels(const PixelProblem& problem, const PixelStart& start,
                                                bool seeks_scale);

}  // namespace mirrorarm::calibration
