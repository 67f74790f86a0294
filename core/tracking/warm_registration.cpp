#include "core/tracking/warm_registration.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/tracking/layout.h"

namespace mirrorarm::tracking {
namespace {

constexpr int kMinForPose = 3;
constexpr double kMaxChance = 1e-3;  // expected number of wrong fits in the gates that is still proof
constexpr double kNear_m = 0.010;    // a wrong fit this near does less harm than none
constexpr int kMaxRounds = 6;
constexpr double kWarmBetaFactor = 1.5;  // a good guess leaves few candidates: the annealing may hasten
// Before the pose is known skin may have moved by a part of the misfit that is accepted in the end.
constexpr double kFirstSlackInRms = 0.25;

}  // namespace

WarmRegistration::WarmRegistration(const WarmSettings& settings) : settings_(settings) {}

const ShapeFit& WarmRegistration::run(const Shape& shape, std::span<const CloudPoint> cloud,
                                      const UncertainPose& predicted) {
  result_.pose = {};
  result_.point_of_marker.assign(shape.size(), -1);
  matches_.clear();
  UncertainPose expected = predicted;
  int gated = 0;
  for (int round = 0; round < kMaxRounds; ++round) {
    before_ = result_.point_of_marker;
    pair(shape, cloud, expected, round == 0);
    gated = std::max(gated, countMatched());
    dropInconsistent(shape, cloud, round == 0);
    if (result_.matched < kMinForPose || (round > 0 && result_.point_of_marker == before_)) break;
    estimate(shape, cloud, expected.X_CT);
    expected = {result_.pose.X_CT, result_.pose.covariance};
  }
  dropOutliers();
  result_.reason = cloud.empty() ? LostReason::kNoPoints : verdict(gated);
  return result_;
}

int WarmRegistration::countMatched() const {
  return static_cast<int>(std::count_if(result_.point_of_marker.begin(), result_.point_of_marker.end(),
                                        [](int point) { return point >= 0; }));
}

void WarmRegistration::pair(const Shape& shape, std::span<const CloudPoint> cloud,
                            const UncertainPose& expected, bool first) {
  pairs_.find(shape, cloud, expected, settings_.gate_sigmas, slack_m());
  if (first) {
    gate_m_ = pairs_.radius_m();
    candidates_ = static_cast<int>(pairs_.all().size());
  }
  if (first && !pairs_.areUnique(cloud)) {
    softassign(shape, cloud, expected);
  } else {
    pairs_.assign(cloud, result_.point_of_marker);
  }
}

/// What each marker's place is uncertain by beyond pose, shape and sensor.
double WarmRegistration::slack_m() const { return std::hypot(settings_.slack_m, result_.pose.excess_m); }

/// Several points for one marker while the pose is uncertain: the nearest need not be right, so all are
/// decided together.
void WarmRegistration::softassign(const Shape& shape, std::span<const CloudPoint> cloud,
                                  const UncertainPose& expected) {
  collectCandidates(shape, cloud);
  SoftassignSettings schedule = settings_.softassign;
  const double spread_mm = 1e3 * std::max(gate_m_ / settings_.gate_sigmas, schedule.tolerated_distance_m);
  schedule.beta_start = std::max(schedule.beta_start, 0.5 / (spread_mm * spread_mm));
  schedule.beta_factor = std::max(schedule.beta_factor, kWarmBetaFactor);
  const SoftassignResult& decided = softassign_.run(x_, y_, schedule, expected.X_CT);
  result_.point_of_marker.assign(shape.size(), -1);
  for (std::size_t i = 0; i < x_.size(); ++i)
    if (decided.y_of_x[i] >= 0)
      result_.point_of_marker[marker_of_x_[i]] = point_of_y_[static_cast<std::size_t>(decided.y_of_x[i])];
}

void WarmRegistration::collectCandidates(const Shape& shape, std::span<const CloudPoint> cloud) {
  x_.clear();
  y_.clear();
  marker_of_x_.clear();
  point_of_y_.clear();
  for (std::size_t j = 0; j < shape.size(); ++j) {
    if (!shape.counts(j)) continue;
    x_.push_back(shape.markers_T[j]);
    marker_of_x_.push_back(j);
  }
  for (const CandidatePair& each : pairs_.all()) {
    if (std::find(point_of_y_.begin(), point_of_y_.end(), each.point) != point_of_y_.end()) continue;
    y_.push_back(cloud[static_cast<std::size_t>(each.point)].p_C);
    point_of_y_.push_back(each.point);
  }
}

void WarmRegistration::dropInconsistent(const Shape& shape, std::span<const CloudPoint> cloud, bool first) {
  result_.matched =
      consistency_.run(shape, cloud, settings_.gate_sigmas,
                       first ? kFirstSlackInRms * settings_.max_rms_m : slack_m(), result_.point_of_marker);
}

void WarmRegistration::estimate(const Shape& shape, std::span<const CloudPoint> cloud,
                                const RigidTransform& start) {
  matches_.clear();
  marker_of_match_.clear();
  for (std::size_t j = 0; j < shape.size(); ++j) {
    if (result_.point_of_marker[j] < 0) continue;
    const CloudPoint& point = cloud[static_cast<std::size_t>(result_.point_of_marker[j])];
    matches_.push_back({shape.markers_T[j], shape.covarianceOf(j), point.p_C, point.covariance_m2});
    marker_of_match_.push_back(j);
  }
  result_.pose = estimator_.estimate(matches_, start);
}

void WarmRegistration::dropOutliers() {
  for (std::size_t i = 0; i < matches_.size(); ++i)
    if (estimator_.weights()[i] == 0.0) result_.point_of_marker[marker_of_match_[i]] = -1;
  result_.matched = countMatched();
}

/// `gated` markers had a point where they were expected.
LostReason WarmRegistration::verdict(int gated) {
  const int needed = std::max(settings_.min_matched, kMinForPose);
  if (gated < needed) return LostReason::kTooFewMarkers;
  if (result_.matched < needed) return LostReason::kBadFit;
  if (gate_m_ > kNear_m && chance() > kMaxChance) return LostReason::kTooFewMarkers;
  if (result_.pose.rms_m > settings_.max_rms_m) return LostReason::kBadFit;
  x_.clear();
  for (const MarkerMatch& match : matches_) x_.push_back(match.marker_T);
  return areCollinear(x_) ? LostReason::kTooFewMarkers : LostReason::kNone;
}

/// How many sets of `result_.matched` pairs that agree on all distances chance would give among the gated
/// ones: any three, each pair of which agrees with the share of the tolerance in the gate, and each further
/// one that finds its point within the tolerance around its place.
double WarmRegistration::chance() const {
  const double agreement = settings_.gate_sigmas * std::numbers::sqrt2 * slack_m() / gate_m_;
  if (agreement >= 1.0) return 0.0;
  double expected = std::pow(agreement, 3);
  for (int i = 0; i < result_.matched; ++i) {
    expected *= static_cast<double>(std::max(1, candidates_ - i)) / (i + 1);
    if (i >= kMinForPose) expected *= std::pow(agreement, 3);
  }
  return expected;
}

}  // namespace mirrorarm::tracking
