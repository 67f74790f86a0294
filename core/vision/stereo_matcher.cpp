#include "core/vision/stereo_matcher.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/vision/epipolar_geometry.h"
#include "core/vision/triangulation.h"

namespace mirrorarm::vision {
namespace {

constexpr double kLeastSeparation_px = 1.0;
constexpr double kScoreRounding = 1e-9;

/// A left and a right marker that may be one disc.
struct Candidate {
  StereoPoint point;
  Eigen::Vector2d cyclopean_px;
  double disparity_px;
  double score = 0.0;
};

using RectifiedPoints = std::vector<std::optional<RectifiedPoint>>;

bool shareAMarker(const Candidate& a, const Candidate& b) {
  return a.point.left == b.point.left || a.point.right == b.point.right;
}

std::optional<Candidate> pairUp(const camera::StereoRig& rig, const EpipolarGeometry& geometry,
                                std::span<const DetectedMarker> lefts, std::span<const DetectedMarker> rights,
                                const RectifiedPoint& left, const RectifiedPoint& right, int l, int r,
                                const MatcherSettings& settings) {
  const double epipolar_px = geometry.epipolarDistance_px(left, right);
  const double disparity_px = left.rectified_px.x() - right.rectified_px.x();
  if (epipolar_px > settings.epipolar_tolerance_px || disparity_px <= 0.0) return std::nullopt;
  const auto point =
      triangulate(rig, lefts[static_cast<std::size_t>(l)], rights[static_cast<std::size_t>(r)]);
  if (!point || point->p_C.z() < settings.min_depth_m || point->p_C.z() > settings.max_depth_m)
    return std::nullopt;
  return Candidate{{point->p_C, point->covariance_m2, l, r, epipolar_px},
                   0.5 * (left.rectified_px + right.rectified_px),
                   disparity_px};
}

std::vector<Candidate> candidatesOf(const camera::StereoRig& rig, std::span<const DetectedMarker> lefts,
                                    std::span<const DetectedMarker> rights, const MatcherSettings& settings) {
  const EpipolarGeometry geometry(rig);
  RectifiedPoints right_points;
  for (const auto& marker : rights) right_points.push_back(geometry.right(marker.centre_px));
  std::vector<Candidate> candidates;
  for (int l = 0; l < static_cast<int>(lefts.size()); ++l) {
    const auto left = geometry.left(lefts[static_cast<std::size_t>(l)].centre_px);
    for (int r = 0; left && r < static_cast<int>(rights.size()); ++r) {
      const auto& right = right_points[static_cast<std::size_t>(r)];
      if (!right) continue;
      const auto candidate = pairUp(rig, geometry, lefts, rights, *left, *right, l, r, settings);
      if (candidate) candidates.push_back(*candidate);
    }
  }
  return candidates;
}

/// What `other` says for `one`: reciprocal cyclopean distance when their disparity gradient is within the
/// limit.
double support(const Candidate& one, const Candidate& other, double max_gradient) {
  if (shareAMarker(one, other)) return 0.0;
  const double separation_px = (one.cyclopean_px - other.cyclopean_px).norm();
  const double difference_px = std::abs(one.disparity_px - other.disparity_px);
  if (difference_px > max_gradient * separation_px) return 0.0;
  return 1.0 / std::max(separation_px, kLeastSeparation_px);
}

/// Adds `sign` times what `one` says for each of the others to their scores.
void spreadSupport(const Candidate& one, double sign, double max_gradient, std::span<Candidate> others) {
  for (auto& other : others) other.score += sign * support(other, one, max_gradient);
}

/// Higher score first; of equal ones (nobody near: score 0) the nearer to its epipolar line.
bool isWorse(const Candidate& a, const Candidate& b) {
  if (std::abs(a.score - b.score) > kScoreRounding) return a.score < b.score;
  return a.point.epipolar_px > b.point.epipolar_px;
}

}  // namespace

std::vector<StereoPoint> matchStereo(const camera::StereoRig& rig, std::span<const DetectedMarker> left,
                                     std::span<const DetectedMarker> right, const MatcherSettings& settings) {
  auto candidates = candidatesOf(rig, left, right, settings);
  const double max_gradient = settings.max_disparity_gradient;
  for (const auto& candidate : candidates) spreadSupport(candidate, 1.0, max_gradient, candidates);
  std::vector<StereoPoint> points;
  while (!candidates.empty()) {
    const Candidate winner = *std::max_element(candidates.begin(), candidates.end(), isWorse);
    points.push_back(winner.point);
    const auto open = std::partition(candidates.begin(), candidates.end(),
                                     [&](const Candidate& other) { return !shareAMarker(winner, other); });
    // A pair that is ruled out no longer speaks for others; the winner does.
    const std::span<Candidate> still_open(candidates.begin(), open);
    for (auto closed = open; closed != candidates.end(); ++closed) {
      const bool is_winner =
          closed->point.left == winner.point.left && closed->point.right == winner.point.right;
      if (!is_winner) spreadSupport(*closed, -1.0, max_gradient, still_open);
    }
    candidates.erase(open, candidates.end());
  }
  return points;
}

}  // namespace mirrorarm::vision
