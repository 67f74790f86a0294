#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/tracking/cloud_point.h"

namespace mirrorarm::tracking {

/// The points of one cloud that a search considers: the first kMaxPoints.
class SearchCloud {
 public:
  /// A point without covariance is taken to be uncertain by `unknown_sigma_m` in each direction.
  void take(std::span<const CloudPoint> cloud, double unknown_sigma_m);

  [[nodiscard]] int size() const { return static_cast<int>(points_.size()); }
  [[nodiscard]] const CloudPoint& operator[](int point) const {
    return points_[static_cast<std::size_t>(point)];
  }
  [[nodiscard]] const Eigen::Vector3d& at(int point) const { return (*this)[point].p_C; }
  /// Mean variance of a point over all directions [m^2].
  [[nodiscard]] double variance(int point) const { return (*this)[point].covariance_m2.trace() / 3.0; }
  /// Standard deviation of a point along `direction`, which may have any length but 0 [m].
  [[nodiscard]] double sigmaAlong(int point, const Eigen::Vector3d& direction) const {
    return sigmaAlong((*this)[point].covariance_m2, direction);
  }
  /// Standard deviation of the distance of two points, `between` them [m].
  [[nodiscard]] double sigmaOfDistance(int one, int other, const Eigen::Vector3d& between) const {
    return sigmaAlong((*this)[one].covariance_m2 + (*this)[other].covariance_m2, between);
  }
  /// Not less than the standard deviation of a point in any direction [m].
  [[nodiscard]] double mostSigma(int point) const { return most_sigma_m_[static_cast<std::size_t>(point)]; }
  /// The largest of those [m].
  [[nodiscard]] double mostSigma() const {
    return most_sigma_m_.empty() ? 0.0 : *std::ranges::max_element(most_sigma_m_);
  }
  /// Mean standard deviation of all points [m].
  [[nodiscard]] double typicalSigma() const { return typical_sigma_m_; }
  /// Radius of a ball, evenly filled, whose points lie as far from its middle as these do (root mean square).
  [[nodiscard]] double radius() const { return radius_m_; }

 private:
  [[nodiscard]] static double sigmaAlong(const Eigen::Matrix3d& covariance_m2,
                                         const Eigen::Vector3d& direction) {
    return std::sqrt(std::max(direction.dot(covariance_m2 * direction), 0.0) / direction.squaredNorm());
  }

  std::vector<CloudPoint> points_;
  std::vector<double> most_sigma_m_;
  double typical_sigma_m_ = 0.0;
  double radius_m_ = 0.0;
};

}  // namespace mirrorarm::tracking
