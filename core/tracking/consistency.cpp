#include "core/tracking/consistency.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>

#include "core/tracking/tracked_target.h"

namespace mirrorarm::tracking {
namespace {

using Eigen::Vector3d;

/// Variance of the difference between two distances, the markers' and the points'.
double distanceVariance(const Shape& shape, std::size_t marker_a, std::size_t marker_b, const CloudPoint& a,
                        const CloudPoint& b, const Vector3d& along_T, const Vector3d& along_C) {
  return along_T.dot((shape.covarianceOf(marker_a) + shape.covarianceOf(marker_b)) * along_T) +
         along_C.dot((a.covariance_m2 + b.covariance_m2) * along_C);
}

bool agree(const Shape& shape, std::size_t marker_a, std::size_t marker_b, const CloudPoint& a,
           const CloudPoint& b, double sigmas, double slack_m) {
  const Vector3d side_T = shape.markers_T[marker_b] - shape.markers_T[marker_a];
  const Vector3d side_C = b.p_C - a.p_C;
  const double length_T = side_T.norm(), length_C = side_C.norm();
  if (!(length_T > 0.0) || !(length_C > 0.0)) return false;
  const double variance =
      distanceVariance(shape, marker_a, marker_b, a, b, side_T / length_T, side_C / length_C) +
      2.0 * slack_m * slack_m;
  const double difference = length_T - length_C;
  return difference * difference <= sigmas * sigmas * variance;
}

}  // namespace

int ConsistencyCheck::run(const Shape& shape, std::span<const CloudPoint> cloud, double sigmas,
                          double slack_m, std::vector<int>& point_of_marker) {
  assert(point_of_marker.size() <= static_cast<std::size_t>(kMaxMarkers));
  matches_.clear();
  for (std::size_t j = 0; j < point_of_marker.size(); ++j)
    if (point_of_marker[j] >= 0) matches_.push_back({j, static_cast<std::size_t>(point_of_marker[j]), 0});
  compareAll(shape, cloud, sigmas, slack_m);
  auto left = static_cast<int>(matches_.size());
  for (; left > 0; --left) {
    const auto worst = std::max_element(matches_.begin(), matches_.end(), [](const Match& a, const Match& b) {
      return std::popcount(a.against) < std::popcount(b.against);
    });
    if (worst->against == 0) break;
    point_of_marker[worst->marker] = -1;
    worst->against = 0;
    const std::uint64_t gone = std::uint64_t{1} << (worst - matches_.begin());
    for (Match& match : matches_) match.against &= ~gone;
  }
  return left;
}

void ConsistencyCheck::compareAll(const Shape& shape, std::span<const CloudPoint> cloud, double sigmas,
                                  double slack_m) {
  for (std::size_t a = 0; a < matches_.size(); ++a)
    for (std::size_t b = a + 1; b < matches_.size(); ++b) {
      if (agree(shape, matches_[a].marker, matches_[b].marker, cloud[matches_[a].point],
                cloud[matches_[b].point], sigmas, slack_m))
        continue;
      matches_[a].against |= std::uint64_t{1} << b;
      matches_[b].against |= std::uint64_t{1} << a;
    }
}

}  // namespace mirrorarm::tracking
