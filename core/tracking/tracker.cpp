#include "core/tracking/tracker.h"

#include <algorithm>
#include <cassert>
#include <optional>
#include <vector>

#include "core/tracking/followed_target.h"
#include "core/tracking/frame_cloud.h"
#include "core/tracking/paper_reteach.h"

namespace mirrorarm::tracking {
namespace {

using vision::StereoPoint;

// How sure a pose from nothing is until it is fitted by likelihood.
constexpr double kFoundTurn_rad = 0.02;
constexpr double kFoundShift_m = 0.0015;
constexpr double kMaxTolerance_m = 0.004;  // beyond it chance explains everything
constexpr int kMinFromNothing = 4;

UncertainPose uncertain(const RigidTransform& X_CT) {
  UncertainPose pose;
  pose.X_CT = X_CT;
  pose.covariance.diagonal().head<3>().setConstant(kFoundTurn_rad * kFoundTurn_rad);
  pose.covariance.diagonal().tail<3>().setConstant(kFoundShift_m * kFoundShift_m);
  return pose;
}

LostReason reasonOf(SearchVerdict verdict) {
  switch (verdict) {
    case SearchVerdict::kFound:
      return LostReason::kNone;
    case SearchVerdict::kTooFewMarkers:
      return LostReason::kTooFewMarkers;
    case SearchVerdict::kAmbiguous:
      return LostReason::kAmbiguous;
    case SearchVerdict::kCutOff:
      return LostReason::kNotConverged;
  }
  return LostReason::kTooFewMarkers;
}

}  // namespace

std::string_view id(TrackingMethod method) {
  return method == TrackingMethod::kSoftassign ? "softassign" : "cliques";
}

std::optional<TrackingMethod> trackingMethodOf(std::string_view name) {
  for (const auto method : {TrackingMethod::kCliques, TrackingMethod::kSoftassign})
    if (name == id(method)) return method;
  return std::nullopt;
}

struct Tracker::Body {
  explicit Body(const TrackerSettings& given)
      : settings(given), warm(given.warm), search(given.search), paper(given.paper) {}

  TrackerSettings settings;
  std::optional<camera::StereoRig> rig;
  std::vector<FollowedTarget> followed;
  std::vector<int> rejections;  ///< in a row, of the paper's method
  bool unlearnt = false;        ///< the last frame still has to be learnt from
  std::vector<TrackedTarget> answers;
  FrameCloud cloud;
  WarmRegistration warm;
  ConstellationSearch search;
  PaperRegistration paper;

  // What the search is given: shapes that follow the skin.
  bool index_is_current = false;
  std::vector<std::span<const Eigen::Vector3d>> shapes_T;
  std::vector<double> tolerances_m;
  std::vector<char> wanted;

  void begin(std::span<const StereoPoint> points, TimePoint exposed_at);
  void followByCliques(TimePoint exposed_at);
  void followByPaper(std::size_t i, TimePoint exposed_at);
  void follow(std::size_t i, TimePoint exposed_at);
  void fitWhereExpected(std::size_t i, TimePoint exposed_at);
  void seekLost(TimePoint exposed_at);
  void refine(std::size_t i, const SearchResult& found, TimePoint exposed_at);
  void refreshIndex();
  [[nodiscard]] double searchTolerance_m(std::size_t i) const;
  void judge(std::size_t i, const ShapeFit& fit, TimePoint exposed_at);
  void accept(std::size_t i, const ShapeFit& fit, TimePoint exposed_at);
  void reteachByPaper(std::size_t i, TimePoint exposed_at);
  void carryOn(std::size_t i, TimePoint exposed_at);
  void predict(const FollowedTarget& target, TimePoint time, TrackedTarget& answer) const;
  [[nodiscard]] bool isTracked(std::size_t i) const { return answers[i].status == TrackStatus::kTracked; }
};

void Tracker::Body::begin(std::span<const StereoPoint> points, TimePoint exposed_at) {
  cloud.reset(points);
  answers.assign(followed.size(), TrackedTarget{});
  for (std::size_t i = 0; i < followed.size(); ++i) {
    followed[i].begin(exposed_at);
    answers[i].exposed_at = exposed_at;
    answers[i].point_of_marker.fill(-1);
    answers[i].reason = cloud.points().empty() ? LostReason::kNoPoints : LostReason::kTooFewMarkers;
  }
}

void Tracker::Body::followByCliques(TimePoint exposed_at) {
  for (std::size_t i = 0; i < followed.size(); ++i)
    if (followed[i].isFresh(exposed_at, settings.follow_for)) follow(i, exposed_at);
  seekLost(exposed_at);
}

void Tracker::Body::follow(std::size_t i, TimePoint exposed_at) {
  fitWhereExpected(i, exposed_at);
  if (answers[i].reason != LostReason::kBadFit) return;
  index_is_current = false;
  // A shape that went with the skin is tried again at once.
  if (followed[i].learnFromMisfit(exposed_at, cloud, rig)) fitWhereExpected(i, exposed_at);
}

void Tracker::Body::fitWhereExpected(std::size_t i, TimePoint exposed_at) {
  FollowedTarget& target = followed[i];
  const UncertainPose expected = target.motion().at(exposed_at);
  const double radius_m =
      gateRadius(target.shape(), expected, settings.warm.gate_sigmas, settings.warm.slack_m);
  const auto near = cloud.selectNear(target.placesAt(expected.X_CT), radius_m);
  judge(i, warm.run(target.shape(), near, expected), exposed_at);
}

void Tracker::Body::seekLost(TimePoint exposed_at) {
  wanted.resize(followed.size());
  for (std::size_t i = 0; i < followed.size(); ++i) wanted[i] = isTracked(i) ? 0 : 1;
  if (std::count(wanted.begin(), wanted.end(), 1) == 0) return;
  if (!index_is_current) refreshIndex();
  const auto found = search.run(cloud.selectFree(), wanted);
  for (std::size_t i = 0; i < followed.size(); ++i)
    if (wanted[i] != 0) refine(i, found[i], exposed_at);
}

double Tracker::Body::searchTolerance_m(std::size_t i) const {
  return std::min(settings.search.tolerance_m + followed[i].skin().tolerance_m(), kMaxTolerance_m);
}

void Tracker::Body::refreshIndex() {
  shapes_T.clear();
  tolerances_m.clear();
  for (std::size_t i = 0; i < followed.size(); ++i) {
    shapes_T.push_back(followed[i].skin().target().markers_T);
    tolerances_m.push_back(searchTolerance_m(i));
  }
  search.setTargets(shapes_T, tolerances_m);
  index_is_current = true;
}

void Tracker::Body::refine(std::size_t i, const SearchResult& found, TimePoint exposed_at) {
  if (found.verdict != SearchVerdict::kFound) {
    // A misfit of the shape where it is expected tells more than a vain search elsewhere.
    const bool told = answers[i].reason == LostReason::kBadFit || answers[i].reason == LostReason::kNoPoints;
    if (!told) answers[i].reason = reasonOf(found.verdict);
    return;
  }
  const ShapeFit& fit = warm.run(followed[i].shape(), cloud.selectFree(), uncertain(found.best.X_CT));
  if (fit.isAccepted() && fit.matched < std::min(kMinFromNothing, found.best.matched)) {
    answers[i].reason = LostReason::kTooFewMarkers;
    return;
  }
  judge(i, fit, exposed_at);
}

void Tracker::Body::judge(std::size_t i, const ShapeFit& fit, TimePoint exposed_at) {
  answers[i].reason = fit.reason;
  if (fit.isAccepted()) accept(i, fit, exposed_at);
}

void Tracker::Body::accept(std::size_t i, const ShapeFit& fit, TimePoint exposed_at) {
  TrackedTarget& answer = answers[i];
  followed[i].accept(fit, exposed_at, cloud);
  answer.status = TrackStatus::kTracked;
  answer.X_CT = fit.pose.X_CT;
  answer.covariance = fit.pose.covariance;
  answer.rms_m = fit.pose.rms_m;
  answer.matched_count = fit.matched;
  const auto point_of_marker = followed[i].pointOfMarker();
  for (std::size_t j = 0; j < point_of_marker.size(); ++j)
    if (point_of_marker[j] >= 0)
      answer.point_of_marker[j] = static_cast<std::int16_t>(cloud.sourceOf(point_of_marker[j]));
}

void Tracker::Body::followByPaper(std::size_t i, TimePoint exposed_at) {
  FollowedTarget& target = followed[i];
  std::optional<RigidTransform> last_X_CT;
  if (target.isFresh(exposed_at, settings.follow_for)) last_X_CT = target.lastPose();
  judge(i, paper.run(target.skin().target().markers_T, cloud.selectFree(), last_X_CT), exposed_at);
  if (isTracked(i) || cloud.countFree() < 3) {
    rejections[i] = 0;
  } else if (++rejections[i] >= settings.paper.rejections_before_reteach) {
    reteachByPaper(i, exposed_at);
  }
}

void Tracker::Body::reteachByPaper(std::size_t i, TimePoint exposed_at) {
  FollowedTarget& target = followed[i];
  if (!target.motion().isKnown()) return;
  const RigidTransform last_X_CT = target.lastPose();
  const auto adapted = paperReteach(target.skin().target(), cloud.selectFree(), last_X_CT, settings.paper);
  if (!adapted) return;
  target.replaceShape(*adapted);
  rejections[i] = 0;
  judge(i, paper.run(target.skin().target().markers_T, cloud.selectFree(), last_X_CT), exposed_at);
}

/// No fit in this frame: for a short while the motion goes on, with growing doubt.
void Tracker::Body::carryOn(std::size_t i, TimePoint exposed_at) {
  if (rig && followed[i].isOutOfView(exposed_at, *rig)) answers[i].reason = LostReason::kOutOfVolume;
  predict(followed[i], exposed_at, answers[i]);
}

/// Nothing when the last measured pose is too old.
void Tracker::Body::predict(const FollowedTarget& target, TimePoint time, TrackedTarget& answer) const {
  if (!target.isFresh(time, settings.predict_for)) return;
  const UncertainPose expected = target.motion().at(time);
  answer.status = TrackStatus::kPredicted;
  answer.X_CT = expected.X_CT;
  answer.covariance = expected.covariance;
}

Tracker::Tracker(const TrackerSettings& settings) : body_(std::make_unique<Body>(settings)) {}
Tracker::~Tracker() = default;
Tracker::Tracker(Tracker&&) noexcept = default;
Tracker& Tracker::operator=(Tracker&&) noexcept = default;

void Tracker::setRig(const camera::StereoRig& rig) { body_->rig = rig; }

void Tracker::setTargets(std::span<const Target> targets) {
  body_->followed.clear();
  for (const Target& target : targets) {
    assert(target.markers_T.size() <= static_cast<std::size_t>(kMaxMarkers));
    body_->followed.emplace_back(target, body_->settings.skin);
  }
  body_->rejections.assign(targets.size(), 0);
  body_->answers.assign(targets.size(), TrackedTarget{});
  body_->index_is_current = false;
  body_->unlearnt = false;
}

std::size_t Tracker::size() const { return body_->followed.size(); }

const Target& Tracker::target(std::size_t index) const { return body_->followed[index].skin().target(); }

int Tracker::version(std::size_t index) const { return body_->followed[index].version(); }

SkinEvent Tracker::event(std::size_t index) const { return body_->followed[index].event(); }

/// After all have taken their points: what is left are strangers.
void Tracker::learn() {
  Body& body = *body_;
  if (!body.unlearnt || body.settings.method != TrackingMethod::kCliques) return;
  body.unlearnt = false;
  for (std::size_t i = 0; i < body.followed.size(); ++i) {
    if (!body.isTracked(i)) continue;
    body.index_is_current = false;
    body.followed[i].learn(body.answers[i].exposed_at, body.cloud, body.rig);
  }
}

std::span<const TrackedTarget> Tracker::track(std::span<const StereoPoint> points, TimePoint exposed_at) {
  Body& body = *body_;
  learn();
  body.begin(points, exposed_at);
  body.unlearnt = true;
  if (body.settings.method == TrackingMethod::kCliques) {
    body.followByCliques(exposed_at);
  } else {
    for (std::size_t i = 0; i < body.followed.size(); ++i) body.followByPaper(i, exposed_at);
  }
  for (std::size_t i = 0; i < body.followed.size(); ++i) {
    if (!body.isTracked(i)) body.carryOn(i, exposed_at);
    const SkinModel& skin = body.followed[i].skin();
    body.answers[i].marker_count = static_cast<int>(skin.shape_T().size());
    body.answers[i].deviation_m = skin.deviation_m();
  }
  return body.answers;
}

TrackedTarget Tracker::at(std::size_t index, TimePoint time) const {
  TrackedTarget answer = body_->answers[index];
  if (answer.status == TrackStatus::kTracked && time == answer.exposed_at) return answer;
  const FollowedTarget& target = body_->followed[index];
  answer.exposed_at = time;
  answer.matched_count = 0;
  answer.point_of_marker.fill(-1);
  answer.status = TrackStatus::kLost;
  if (!target.motion().isKnown()) return answer;
  answer.reason = LostReason::kStale;
  body_->predict(target, time, answer);
  return answer;
}

}  // namespace mirrorarm::tracking
