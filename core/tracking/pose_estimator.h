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
  double chi2 = 0.0;      ///< misfit in units of the covariances given, outliers at their robust cost
  int freedom = 0;        ///< 3 * matches - 6
  double rms_m = 0.0;     ///< of point minus marker over all matches but the outliers
  double excess_m = 0.0;  ///< standard deviation of a coordinate that the covariances given do not explain
};

/// The pose of greatest likelihood of the centres in both images.
///
/// A triangulated point with its covariance says all that its two images say about the pose: of the four
/// coordinates three fix the point, the fourth, the epipolar distance, no pose can change. So the sum of
/// (y - X x)' C^-1 (y - X x) over the points, C their covariance (long in depth) and the model's together, is
/// the reprojection's likelihood to second order; a test holds it against the pixels themselves.
///
/// Gauss-Newton with robust weights (Huber to `huber_sigmas`, none beyond `outlier_sigmas`; a sigma is wider
/// while the median match fits worse than it should: far from the answer, or on a body that deforms). The
/// covariance is the inverse of J' W J. Only when the misfit is larger than chance allows in 999 of 1000
/// cases is an equal variance in all directions added to each match until it is explained (`excess_m`), so
/// that the covariance of a rigid target stays honest and that of a deforming one is not too small.
/// Covariances that are zero throughout mean an unknown sensor: all matches then weigh the same and the
/// misfit alone tells the variance. Sources: Pustka et al., Optical outside-in tracking with 6D uncertainty,
/// ISMAR 2010; Barfoot, State Estimation for Robotics, 2017, ch. 8; Paule and Mandel, J. Res. NBS 87(5),
/// 1982.
class PoseEstimator {
 public:
  struct Settings {
    double huber_sigmas = 3.0;
    double outlier_sigmas = 6.0;
    int max_steps = 20;
  };
  PoseEstimator() : PoseEstimator(Settings{}) {}
  explicit PoseEstimator(const Settings& settings) : settings_(settings) {}

  /// From `start`, off by up to a few centimetres and 20 degrees. At least 3 matches; when they lie on a line
  /// the covariance tells that the turn about it is not known. The answer stays good until the next call;
  /// nothing is taken from the heap once the buffers have grown.
  [[nodiscard]] const PoseEstimate& estimate(std::span<const MarkerMatch> matches,
                                             const RigidTransform& start);
  /// Share 0..1 that each match of the last estimate had; 0 for an outlier.
  [[nodiscard]] std::span<const double> weights() const { return weights_; }

 private:
  using Matrix6d = Eigen::Matrix<double, 6, 6>;
  using Vector6d = Eigen::Matrix<double, 6, 1>;
  /// A match seen from the pose at hand.
  struct Residual {
    Eigen::Vector3d r_T = Eigen::Vector3d::Zero();              ///< point minus marker [m]
    Eigen::Matrix3d information = Eigen::Matrix3d::Identity();  ///< inverse of its covariance [1/m^2]
    double sigmas = 0.0;                                        ///< Mahalanobis length of r_T
  };
  /// What the inliers say about the variance that is missing.
  struct Misfit {
    double chi2 = 0.0;
    double slope = 0.0;  ///< -d(chi2)/d(variance) [1/m^2]
    int freedom = 0;
  };

  void descend(std::span<const MarkerMatch> matches);
  void see(std::span<const MarkerMatch> matches);
  void weigh();
  [[nodiscard]] double robustWeight(double sigmas) const;
  [[nodiscard]] double step(std::span<const MarkerMatch> matches);
  [[nodiscard]] double robustChi2() const;
  [[nodiscard]] Misfit misfit() const;
  void explain(std::span<const MarkerMatch> matches);
  [[nodiscard]] double inlierRms() const;

  Settings settings_;
  PoseEstimate estimate_;
  double excess_m2_ = 0.0;  ///< variance added to each coordinate
  double scale_ = 1.0;      ///< sigmas that count as one
  std::vector<Residual> residuals_;
  std::vector<double> weights_;
  std::vector<double> sorted_;
};

}  // namespace mirrorarm::tracking
