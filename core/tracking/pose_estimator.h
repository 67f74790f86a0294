#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/geometry/rigid_transform.h"

namespace mirrorarm::tracking {

/// A marker and the point that was taken for it.
struct MarkerMatch {
  Eigen::Vector3d marker_T = Eigen::Vector3d::Zero();              ///< where the model has it [m]
  Eigen::Matrix3d marker_covariance_m2 = Eigen::Matrix3d::Zero();  ///< of that, in T: teaching and skin
  Eigen::Vector3d point_C = Eigen::Vector3d::Zero();               ///< where it was measured [m]
  Eigen::Matrix3d point_covariance_m2 = Eigen::Matrix3d::Zero();   ///< of that, in C
};

struct PoseEstimate {
  RigidTransform X_CT = RigidTransform::Identity();
  /// Turn [rad] then shift [m], as a small motion in T: X_CT * exp(d).
  Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Zero();
  double chi2 = 0.0;   ///< misfit in units of the covariances given, outliers at their robust cost
  int freedom = 0;     ///< 3 * matches - 6
  double rms_m = 0.0;  ///< of point minus marker over matches of full weight
};

/// The pose of greatest likelihood of the centres in both images.
///
/// A triangulated point with its covariance says all that its two images say about the pose: of the four
/// coordinates three fix the point, the fourth, the epipolar distance, no pose can change. So the sum of
/// (y - X x)' C^-1 (y - X x) over the points, C their covariance (long in depth) and the model's together, is
/// the reprojection's likelihood to second order; a test holds it against the pixels themselves.
/// Gauss-Newton with robust weights (Huber to `huber_sigmas`, none beyond `outlier_sigmas`). The covariance
/// is the inverse of J' W J, widened when the misfit is larger than the covariances explain. Source: Pustka
/// et al., Optical outside-in tracking with 6D uncertainty, ISMAR 2010; Barfoot, State Estimation for
/// Robotics, 2017, ch. 8.
class PoseEstimator {
 public:
  struct Settings {
    double huber_sigmas = 3.0;
    double outlier_sigmas = 6.0;
    int max_steps = 10;
  };
  PoseEstimator() : PoseEstimator(Settings{}) {}
  explicit PoseEstimator(const Settings& settings);

  /// From `start`, off by up to a few centimetres and 20 degrees. At least 3 matches not on a line. The
  /// answer stays good until the next call; nothing is taken from the heap once the buffers have grown.
  [[nodiscard]] const PoseEstimate& estimate(std::span<const MarkerMatch> matches,
                                             const RigidTransform& start);
  /// Share 0..1 that each match of the last estimate had; 0 for an outlier.
  [[nodiscard]] std::span<const double> weights() const;
};

}  // namespace mirrorarm::tracking
