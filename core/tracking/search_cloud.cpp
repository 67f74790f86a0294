#include "core/tracking/search_cloud.h"

#include <algorithm>
#include <cmath>

#include "core/tracking/tracked_target.h"

namespace mirrorarm::tracking {
namespace {

using Eigen::Vector3d;

bool isKnown(const Eigen::Matrix3d& covariance_m2) {
  return covariance_m2.allFinite() && covariance_m2.diagonal().minCoeff() >= 0.0 &&
         covariance_m2.trace() > 0.0;
}

double evenRadius(std::span<const CloudPoint> points) {
  if (points.empty()) return 0.0;
  const auto count = static_cast<double>(points.size());
  Vector3d mean = Vector3d::Zero();
  for (const auto& point : points) mean += point.p_C / count;
  double square = 0.0;
  for (const auto& point : points) square += (point.p_C - mean).squaredNorm() / count;
  return std::sqrt(5.0 / 3.0 * square);
}

}  // namespace

void SearchCloud::take(std::span<const CloudPoint> cloud, double unknown_sigma_m) {
  const auto considered = cloud.first(std::min(cloud.size(), kMaxPoints));
  points_.assign(considered.begin(), considered.end());
  most_sigma_m_.clear();
  typical_sigma_m_ = 0.0;
  for (auto& point : points_) {
    if (!isKnown(point.covariance_m2))
      point.covariance_m2 = unknown_sigma_m * unknown_sigma_m * Eigen::Matrix3d::Identity();
    most_sigma_m_.push_back(std::sqrt(point.covariance_m2.trace()));
    typical_sigma_m_ += most_sigma_m_.back() / std::sqrt(3.0) / static_cast<double>(points_.size());
  }
  radius_m_ = evenRadius(points_);
}

}  // namespace mirrorarm::tracking
