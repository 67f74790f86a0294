#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

namespace mirrorarm::tracking {

/// One sighting within a linearised network: the residual, point minus marker in T, and what it weighs.
struct NetworkTerm {
  int frame = 0;
  int marker = 0;
  Eigen::Vector3d residual_T = Eigen::Vector3d::Zero();
  Eigen::Matrix3d sensor_T = Eigen::Matrix3d::Zero();  ///< the sensor's covariance in T; zero: not known
  Eigen::Matrix3d weight = Eigen::Matrix3d::Zero();    ///< inverse of sensor and spread together
  double trust = 1.0;                                  ///< 1 within the robust limit, 0 for an outlier
  Eigen::Matrix<double, 3, 6> motion;                  ///< of the marker with turn and shift of T
  Eigen::Matrix<double, 6, 3> pull;                    ///< motion' * weight * trust: on the frame's pose
  Eigen::Matrix<double, 6, 3> lever;                   ///< covariance of the frame's pose * pull
};

/// Standard deviations per axis that the markers show beyond the sensor, from residuals whose scale is not
/// known yet: by medians, so that outliers do not count; somewhat too large rather than too small.
void guessSpreads(std::span<const NetworkTerm> terms, std::vector<double>& spread_m);

/// Fisher scoring of the restricted likelihood for all markers' spreads at once; the terms frame by frame.
class SpreadEstimator {
 public:
  /// One step. The last one, `only_significant`, makes those 0 that chance explains where the sensor's
  /// covariance is known.
  void improve(std::span<const NetworkTerm> terms, std::vector<double>& spread_m, bool only_significant);

 private:
  void score(std::span<const NetworkTerm> terms, std::size_t markers);
  void scoreFrame(std::span<const NetworkTerm> terms);
  void keepUnknownSensorsAlike(std::vector<double>& spread_m) const;

  std::vector<Eigen::Matrix3d> position_covariance_m2_;  ///< of each marker, poses given
  std::vector<char> knows_sensor_;
  double share_ = 1.0;           ///< of the freedom that positions take
  Eigen::VectorXd surplus_;      ///< of squared residuals over what is expected of them
  Eigen::MatrixXd information_;  ///< of all variances
};

/// For each marker in how many successive sightings its residuals repeat themselves: 1 when each is new, more
/// when what moves it lasts. Sum of the autocorrelation up to where it is lost in noise (Sokal, 1997).
[[nodiscard]] std::vector<double> correlationTimes(std::span<const NetworkTerm> terms, std::size_t markers);

}  // namespace mirrorarm::tracking
