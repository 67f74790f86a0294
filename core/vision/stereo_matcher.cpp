#include "core/vision/stereo_matcher.h"

#include <algorithm>
#include <cmath>

#include "core/vision/pair_measurement.h"

namespace mirrorarm::vision {
namespace {

double squared(double x) { return x * x; }

/// Half of the calibration's error each: a rig's record tells the distance of one centre from the other's
/// line.
double calibrationVariance(const camera::StereoRig& rig, const MatcherSettings& settings) {
  const double recorded_px = rig.calibration.hold_out_epipolar_px;
  const double sigma_px = recorded_px > 0.0 ? recorded_px : settings.unknown_calibration_px;
  return 0.5 * squared(std::max(sigma_px, settings.least_calibration_px));
}

const DetectedMarker& at(std::span<const DetectedMarker> markers, int index) {
  return markers[static_cast<std::size_t>(index)];
}

/// Preferred ones first, then by support; of equal ones the first found.
bool comesBefore(const StereoPoint& a, const StereoPoint& b) {
  if (a.preferred != b.preferred) return a.preferred;
  if (a.support != b.support) return a.support > b.support;
  return a.left != b.left ? a.left < b.left : a.right < b.right;
}

}  // namespace

StereoMatcher::StereoMatcher(const camera::StereoRig& rig, const MatcherSettings& settings)
    : rig_(rig),
      settings_(settings),
      geometry_(rig),
      calibration_variance_px2_(calibrationVariance(rig, settings)) {}

std::span<const StereoPoint> StereoMatcher::match(std::span<const DetectedMarker> left,
                                                  std::span<const DetectedMarker> right) {
  sight(left, Side::kLeft, lefts_);
  sight(right, Side::kRight, rights_);
  collect();
  keepTheNearest();
  pairs_.clear();
  points_.clear();
  for (const auto& candidate : candidates_) measure(candidate, left, right);
  fillSupport(pairs_, settings_.max_disparity_gradient, points_);
  std::sort(points_.begin(), points_.end(), comesBefore);
  return points_;
}

/// Markers without a ray, or with numbers that are none, stay out.
void StereoMatcher::sight(std::span<const DetectedMarker> markers, Side side,
                          std::vector<Sighting>& sightings) const {
  sightings.clear();
  for (std::size_t i = 0; i < markers.size(); ++i) {
    const auto& marker = markers[i];
    const auto point =
        side == Side::kLeft ? geometry_.left(marker.centre_px) : geometry_.right(marker.centre_px);
    if (!point || !point->rectified_px.allFinite()) continue;
    const Eigen::RowVector2d& gain = point->row_by_pixel;
    const double variance_px2 =
        gain.dot(gain * marker.covariance_px2) + calibration_variance_px2_ * gain.squaredNorm();
    if (std::isfinite(variance_px2)) sightings.push_back({*point, variance_px2, static_cast<int>(i)});
  }
}

void StereoMatcher::collect() {
  std::sort(rights_.begin(), rights_.end(), [](const Sighting& a, const Sighting& b) {
    return a.at.rectified_px.y() < b.at.rectified_px.y();
  });
  double most_variance_px2 = 0.0;
  for (const auto& right : rights_) most_variance_px2 = std::max(most_variance_px2, right.row_variance_px2);
  candidates_.clear();
  for (std::size_t i = 0; i < lefts_.size(); ++i)
    collectNear(i,
                settings_.epipolar_gate_sigmas * std::sqrt(lefts_[i].row_variance_px2 + most_variance_px2));
}

void StereoMatcher::collectNear(std::size_t left, double reach_px) {
  const Sighting& l = lefts_[left];
  const double row_px = l.at.rectified_px.y();
  auto r = std::lower_bound(
      rights_.begin(), rights_.end(), row_px - reach_px,
      [](const Sighting& sighting, double row) { return sighting.at.rectified_px.y() < row; });
  for (; r != rights_.end() && r->at.rectified_px.y() <= row_px + reach_px; ++r) {
    const double off_px = r->at.rectified_px.y() - row_px;
    const double misfit = squared(off_px) / (l.row_variance_px2 + r->row_variance_px2);
    if (isPossible(l, *r, misfit))
      candidates_.push_back({static_cast<int>(left), static_cast<int>(r - rights_.begin()), misfit});
  }
}

bool StereoMatcher::isPossible(const Sighting& left, const Sighting& right, double epipolar_misfit) const {
  if (epipolar_misfit > squared(settings_.epipolar_gate_sigmas)) return false;
  if (!(left.at.rectified_px.x() > right.at.rectified_px.x())) return false;
  const double depth_m = geometry_.pointOf(left.at, right.at).z();
  return depth_m >= settings_.min_depth_m && depth_m <= settings_.max_depth_m;
}

void StereoMatcher::keepTheNearest() {
  if (candidates_.size() <= kMostPairs) return;
  const auto end = candidates_.begin() + kMostPairs;
  std::nth_element(candidates_.begin(), end, candidates_.end(), [](const Candidate& a, const Candidate& b) {
    return a.epipolar_misfit < b.epipolar_misfit;
  });
  candidates_.erase(end, candidates_.end());
}

void StereoMatcher::measure(const Candidate& candidate, std::span<const DetectedMarker> left,
                            std::span<const DetectedMarker> right) {
  const Sighting& l = lefts_[static_cast<std::size_t>(candidate.left)];
  const Sighting& r = rights_[static_cast<std::size_t>(candidate.right)];
  auto pair =
      measurePair(rig_, settings_, geometry_.pointOf(l.at, r.at), at(left, l.marker), at(right, r.marker));
  if (!pair) return;
  pair->point.left = l.marker;
  pair->point.right = r.marker;
  pair->point.epipolar_px = EpipolarGeometry::epipolarDistance_px(l.at, r.at);
  points_.push_back(pair->point);
  pairs_.push_back({0.5 * (l.at.rectified_px + r.at.rectified_px),
                    l.at.rectified_px.x() - r.at.rectified_px.x(),
                    candidate.epipolar_misfit + pair->shape_misfit});
}

}  // namespace mirrorarm::vision
