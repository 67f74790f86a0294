#include "core/tracking/tracker.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <vector>

#include "core/tracking/fit_covariance.h"
#include "core/tracking/pose_trend.h"
#include "core/tracking/registration.h"

namespace mirrorarm::tracking {
namespace {

using Eigen::Vector3d;
using vision::StereoPoint;

constexpr int kMinForFirstFit = 4;
constexpr double kDeformationInRms = 3.0;  // how far a marker on skin strays from the rigid model
constexpr double kUncertaintyInSigma = 3.0;
constexpr auto kMaxIndex = static_cast<std::size_t>(std::numeric_limits<std::int16_t>::max());

/// What is kept of one target from frame to frame.
struct Followed {
  PoseTrend trend;
  Eigen::Matrix<double, 6, 6> covariance =
      Eigen::Matrix<double, 6, 6>::Zero();  ///< of the last measured pose
  double reach_m = 0.0;                     ///< of the outermost marker from T's origin
  int rejections = 0;
};

SeenDiscs discsOf(const StereoPoint& point) { return {point.left, point.right}; }

double reachOf(const Target& target) {
  double reach = 0.0;
  for (const auto& p : target.markers_T) reach = std::max(reach, p.norm());
  return reach;
}

}  // namespace

struct Tracker::Body {
  TrackerSettings settings;
  std::vector<Target> targets;
  std::vector<Followed> followed;
  std::vector<TrackedTarget> answers;

  // The frame: all points, which are taken, and those that one target looks at with their place among all.
  std::span<const StereoPoint> points;
  std::vector<char> taken;
  std::vector<Vector3d> cloud_C;
  std::vector<std::size_t> source;
  std::vector<SeenDiscs> discs;

  Registration registration;
  std::vector<Vector3d> matched_T, matched_C;
  std::vector<Eigen::Matrix3d> matched_covariance;

  void begin(std::span<const StereoPoint> frame, TimePoint exposed_at);
  void follow(std::size_t i, TimePoint exposed_at);
  void seek(std::size_t i, TimePoint exposed_at);
  void carryOn(std::size_t i, TimePoint exposed_at);
  void collectFree();
  void clearCloud();
  void collect(std::size_t point);
  void take(std::size_t point);
  void collectNear(const Target& target, const RigidTransform& X_CT, double radius_m);
  void judge(std::size_t i, const RegistrationResult& fit, TimePoint exposed_at);
  void accept(std::size_t i, const RegistrationResult& fit, TimePoint exposed_at);
  [[nodiscard]] bool isFree(std::size_t point) const;
  [[nodiscard]] int countFree() const;
  [[nodiscard]] int minMatched(const Target& target) const;
  [[nodiscard]] bool isFresh(std::size_t i, TimePoint exposed_at) const;
  [[nodiscard]] RegistrationSettings registrationSettings(int min_matched) const;
};

void Tracker::Body::begin(std::span<const StereoPoint> frame, TimePoint exposed_at) {
  points = frame.first(std::min(frame.size(), kMaxIndex + 1));
  taken.assign(points.size(), 0);
  answers.assign(targets.size(), TrackedTarget{});
  for (std::size_t i = 0; i < targets.size(); ++i) {
    answers[i].exposed_at = exposed_at;
    answers[i].marker_count = static_cast<int>(targets[i].markers_T.size());
    answers[i].point_of_marker.fill(-1);
  }
}

bool Tracker::Body::isFree(std::size_t point) const {
  return taken[point] == 0 && points[point].p_C.allFinite();
}

int Tracker::Body::countFree() const {
  int count = 0;
  for (std::size_t i = 0; i < points.size(); ++i) count += isFree(i) ? 1 : 0;
  return count;
}

void Tracker::Body::clearCloud() {
  cloud_C.clear();
  source.clear();
  discs.clear();
}

void Tracker::Body::collect(std::size_t point) {
  cloud_C.push_back(points[point].p_C);
  source.push_back(point);
  discs.push_back(discsOf(points[point]));
}

/// With a point all others that claim one of its discs are gone.
void Tracker::Body::take(std::size_t point) {
  taken[point] = 1;
  if (points[point].rivals == 0) return;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (shareADisc(discsOf(points[i]), discsOf(points[point]))) taken[i] = 1;
}

void Tracker::Body::collectFree() {
  clearCloud();
  for (std::size_t i = 0; i < points.size() && source.size() < kMaxPoints; ++i)
    if (isFree(i)) collect(i);
}

void Tracker::Body::collectNear(const Target& target, const RigidTransform& X_CT, double radius_m) {
  clearCloud();
  for (std::size_t i = 0; i < points.size() && source.size() < kMaxPoints; ++i) {
    const bool near =
        isFree(i) && std::any_of(target.markers_T.begin(), target.markers_T.end(), [&](const auto& p_T) {
          return (X_CT * p_T - points[i].p_C).squaredNorm() < radius_m * radius_m;
        });
    if (near) collect(i);
  }
}

int Tracker::Body::minMatched(const Target& target) const {
  const auto share = settings.min_marker_share * static_cast<double>(target.markers_T.size());
  return std::max(3, static_cast<int>(std::ceil(share - 1e-9)));
}

RegistrationSettings Tracker::Body::registrationSettings(int min_matched) const {
  return {settings.softassign, settings.full_schedule, settings.max_rms_m, min_matched};
}

bool Tracker::Body::isFresh(std::size_t i, TimePoint exposed_at) const {
  const PoseTrend& trend = followed[i].trend;
  return trend.isKnown() && trend.ageAt(exposed_at) <= settings.follow_for;
}

void Tracker::Body::follow(std::size_t i, TimePoint exposed_at) {
  const PoseTrend& trend = followed[i].trend;
  const RigidTransform X_CT = trend.at(exposed_at);
  const double uncertainty_m = trend.uncertaintyAt(exposed_at);
  collectNear(targets[i], X_CT, uncertainty_m + kDeformationInRms * settings.max_rms_m);
  const auto needed = registrationSettings(minMatched(targets[i]));
  registration.setDiscs(discs);
  judge(i, registration.follow(targets[i].markers_T, cloud_C, needed, X_CT, uncertainty_m), exposed_at);
}

/// Nothing but the shape speaks for a first fit: three markers alone would too often be found by chance.
void Tracker::Body::seek(std::size_t i, TimePoint exposed_at) {
  const auto markers = static_cast<int>(targets[i].markers_T.size());
  const int needed = std::max(minMatched(targets[i]), std::min(kMinForFirstFit, markers));
  collectFree();
  registration.setDiscs(discs);
  judge(i, registration.search(targets[i].markers_T, cloud_C, registrationSettings(needed)), exposed_at);
}

void Tracker::Body::judge(std::size_t i, const RegistrationResult& fit, TimePoint exposed_at) {
  // A misfit of the model near its prediction tells more than a vain search elsewhere.
  if (fit.isAccepted() || answers[i].reason != LostReason::kBadFit) answers[i].reason = fit.reason;
  if (fit.isAccepted()) accept(i, fit, exposed_at);
}

void Tracker::Body::accept(std::size_t i, const RegistrationResult& fit, TimePoint exposed_at) {
  TrackedTarget& answer = answers[i];
  matched_T.clear();
  matched_C.clear();
  matched_covariance.clear();
  for (std::size_t j = 0; j < fit.y_of_x.size(); ++j) {
    if (fit.y_of_x[j] < 0) continue;
    const std::size_t point = source[static_cast<std::size_t>(fit.y_of_x[j])];
    take(point);
    answer.point_of_marker[j] = static_cast<std::int16_t>(point);
    matched_T.push_back(targets[i].markers_T[j]);
    matched_C.push_back(points[point].p_C);
    matched_covariance.push_back(points[point].covariance_m2);
  }
  answer.status = TrackStatus::kTracked;
  answer.X_CT = fit.X_YX;
  answer.rms_m = fit.rms_m;
  answer.matched_count = fit.matched;
  answer.covariance = fitCovariance(fit.X_YX, matched_T, matched_C, matched_covariance);
  followed[i].trend.add(exposed_at, fit.X_YX);
  followed[i].covariance = answer.covariance;
  followed[i].rejections = 0;
}

/// No fit in this frame: for a short while the motion goes on, with growing doubt.
void Tracker::Body::carryOn(std::size_t i, TimePoint exposed_at) {
  Followed& target = followed[i];
  if (countFree() >= minMatched(targets[i])) ++target.rejections;
  if (!target.trend.isKnown() || target.trend.ageAt(exposed_at) > settings.predict_for) return;
  answers[i].status = TrackStatus::kPredicted;
  answers[i].X_CT = target.trend.at(exposed_at);
  const double doubt_m = target.trend.uncertaintyAt(exposed_at) / kUncertaintyInSigma;
  const double doubt_rad = doubt_m / std::max(target.reach_m, doubt_m);
  answers[i].covariance = target.covariance;
  answers[i].covariance.diagonal().head<3>().array() += doubt_rad * doubt_rad;
  answers[i].covariance.diagonal().tail<3>().array() += doubt_m * doubt_m;
}

Tracker::Tracker(const TrackerSettings& settings) : body_(std::make_unique<Body>()) {
  body_->settings = settings;
}

Tracker::~Tracker() = default;
Tracker::Tracker(Tracker&&) noexcept = default;
Tracker& Tracker::operator=(Tracker&&) noexcept = default;

void Tracker::setTargets(std::span<const Target> targets) {
  body_->targets.assign(targets.begin(), targets.end());
  body_->followed.assign(targets.size(), Followed{});
  for (std::size_t i = 0; i < targets.size(); ++i) {
    assert(targets[i].markers_T.size() <= static_cast<std::size_t>(kMaxMarkers));
    body_->followed[i].reach_m = reachOf(targets[i]);
  }
}

void Tracker::replaceTarget(std::size_t index, const Target& target) {
  assert(index < body_->targets.size());
  assert(target.markers_T.size() <= static_cast<std::size_t>(kMaxMarkers));
  body_->targets[index] = target;
  body_->followed[index].reach_m = reachOf(target);
  body_->followed[index].rejections = 0;
}

std::span<const Target> Tracker::targets() const { return body_->targets; }

std::span<const TrackedTarget> Tracker::track(std::span<const StereoPoint> points, TimePoint exposed_at) {
  body_->begin(points, exposed_at);
  const std::size_t count = body_->targets.size();
  const auto isTracked = [this](std::size_t i) { return body_->answers[i].status == TrackStatus::kTracked; };
  for (std::size_t i = 0; i < count; ++i)
    if (body_->isFresh(i, exposed_at)) body_->follow(i, exposed_at);
  for (std::size_t i = 0; i < count; ++i)
    if (!isTracked(i)) body_->seek(i, exposed_at);
  for (std::size_t i = 0; i < count; ++i)
    if (!isTracked(i)) body_->carryOn(i, exposed_at);
  return body_->answers;
}

bool Tracker::needsReteaching(std::size_t index) const {
  assert(index < body_->followed.size());
  return body_->followed[index].rejections >= body_->settings.rejections_before_reteach;
}

}  // namespace mirrorarm::tracking
