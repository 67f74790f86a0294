#include "core/tracking/skin_model.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <vector>

#include "core/tracking/deviation_filter.h"
#include "core/tracking/marker_presence.h"
#include "core/tracking/slip_watch.h"
#include "core/tracking/stranger_watch.h"
#include "core/tracking/tracked_target.h"
#include "core/tracking/wide_match.h"

namespace mirrorarm::tracking {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kUnknownSensor_m2 = 2e-5 * 2e-5;
constexpr double kSigmasOfPlace = 4.0;
constexpr double kStrangerMoves_m = 0.003;  // on the body, from frame to frame
constexpr double kSlipReach_m = 0.025;      // how far a slip may carry a marker
constexpr double kStray_m = 0.012;          // how far skin may carry one that is hidden
constexpr Seconds kSlipTakes{0.15};         // a marker's end and its return elsewhere may lie so far apart
constexpr double kShareToTellJumps = 0.6;
constexpr int kFramesToSettle = 8;
constexpr double kToleranceSigmas = 3.0;

/// Variance of a place that was taught by so few frames of a moving skin.
Matrix3d taughtAgain(const Matrix3d& sensor_m2, double skin_m2) {
  return sensor_m2 + skin_m2 * Matrix3d::Identity();
}

}  // namespace

std::string_view id(SkinEvent event) {
  switch (event) {
    case SkinEvent::kNone:
      return "none";
    case SkinEvent::kSlipped:
      return "slipped";
    case SkinEvent::kMarkerLost:
      return "marker_lost";
    case SkinEvent::kMarkerFound:
      return "marker_found";
    case SkinEvent::kMarkerAdded:
      return "marker_added";
  }
  return "none";
}

struct SkinModel::Body {
  SkinSettings settings;
  Target target;
  int version = 0;
  DeviationFilter filter;
  MarkerPresence presence;
  StrangerWatch strangers;
  SlipWatch slips;
  WideMatch wide;

  // Deviations are told in the mean frame G of all markers; the frame T that is shown is carried by the
  // stiff ones. At rest they are one.
  RigidTransform X_TG = RigidTransform::Identity();
  std::vector<Vector3d> shape_G;
  std::vector<Vector3d> shape_T;
  std::vector<Matrix3d> covariance_m2;
  std::vector<double> variances_m2;
  std::vector<SeenMarker> seen;
  std::vector<char> is_seen;  ///< a flag for each marker of the frame
  std::vector<char> is_free;  ///< a flag for each point of it
  TimePoint now{};
  bool observed = false;
  std::optional<RigidTransform> found_pose;

  Body(const Target& taught, const SkinSettings& skin);
  void resize();
  void shapeFromParts();
  void collect(const SkinObservation& frame);
  void addSeen(const SkinObservation& frame, const RigidTransform& X_GC, std::size_t marker, int point);
  [[nodiscard]] int pointNear(const SkinObservation& frame, const RigidTransform& X_TC,
                              std::size_t marker) const;
  [[nodiscard]] bool canTellJumps() const;
  void takeJumps();
  void learn(const SkinObservation& frame);
  void adaptRest(Seconds step);
  void watchStrangers(const SkinObservation& frame);
  bool judgeSlips();
  [[nodiscard]] bool replaces(std::size_t marker, const Stranger& stranger) const;
  [[nodiscard]] std::size_t markerAt(const Stranger& stranger) const;
  bool takeUpStrays();
  bool addMarker();
  [[nodiscard]] bool belongsToBody(const Stranger& stranger) const;
  SkinEvent conclude(const SkinObservation& frame, Seconds step);
};

SkinModel::Body::Body(const Target& taught, const SkinSettings& skin)
    : settings(skin),
      target(taught),
      filter(skin.learning_time),
      presence(skin.missing_time),
      slips(skin.slip_sigmas, skin.slip_time) {
  assert(target.markers_T.size() <= static_cast<std::size_t>(kMaxMarkers));
  is_free.reserve(kMaxPoints);
  resize();
  shapeFromParts();
}

void SkinModel::Body::resize() {
  const std::size_t markers = target.markers_T.size();
  target.markers_covariance_m2.resize(markers, Matrix3d::Zero());
  filter.resize(markers);
  presence.resize(markers);
  slips.resize(markers);
  shape_G.resize(markers);
  shape_T.resize(markers);
  covariance_m2.resize(markers);
  variances_m2.resize(markers);
  is_seen.resize(markers, 0);
  seen.reserve(markers);
}

void SkinModel::Body::shapeFromParts() {
  X_TG = filter.stiffMotion();
  const Matrix3d R_TG = X_TG.linear();
  for (std::size_t i = 0; i < shape_G.size(); ++i) {
    shape_G[i] = target.markers_T[i] + slips.offset(i) + filter.expected(i);
    shape_T[i] = X_TG * shape_G[i];
    variances_m2[i] = filter.variance(i);
    covariance_m2[i] =
        R_TG * target.markers_covariance_m2[i] * R_TG.transpose() + variances_m2[i] * Matrix3d::Identity();
  }
}

void SkinModel::Body::collect(const SkinObservation& frame) {
  assert(frame.point_of_marker.size() <= target.markers_T.size());
  assert(frame.taken.size() == frame.cloud.size());
  is_free.resize(frame.cloud.size());
  for (std::size_t k = 0; k < frame.cloud.size(); ++k) is_free[k] = frame.taken[k] == 0 ? 1 : 0;
  std::fill(is_seen.begin(), is_seen.end(), 0);
  seen.clear();
  const RigidTransform X_GC = (frame.X_CT * X_TG).inverse();
  for (std::size_t i = 0; i < frame.point_of_marker.size(); ++i)
    addSeen(frame, X_GC, i, frame.point_of_marker[i]);
  // One that has fallen off is not looked for by others.
  for (std::size_t i = 0; i < shape_G.size(); ++i)
    if (presence.present()[i] == 0 && is_seen[i] == 0) addSeen(frame, X_GC, i, pointNear(frame, X_GC, i));
}

void SkinModel::Body::addSeen(const SkinObservation& frame, const RigidTransform& X_GC, std::size_t marker,
                              int point) {
  if (point < 0) return;
  const CloudPoint& measured = frame.cloud[static_cast<std::size_t>(point)];
  is_free[static_cast<std::size_t>(point)] = 0;
  is_seen[marker] = 1;
  if (presence.present()[marker] == 0) return;
  const Matrix3d sensor_m2 = X_GC.linear() * measured.covariance_m2 * X_GC.linear().transpose();
  SeenMarker& added = seen.emplace_back();
  added.marker = marker;
  added.place_T = shape_G[marker];
  added.innovation = X_GC * measured.p_C - shape_G[marker];
  added.sensor_m2 = sensor_m2 + target.markers_covariance_m2[marker];
  if (sensor_m2.isZero(0.0)) added.sensor_m2 += kUnknownSensor_m2 * Matrix3d::Identity();
}

int SkinModel::Body::pointNear(const SkinObservation& frame, const RigidTransform& X_GC,
                               std::size_t marker) const {
  const double gate = kStrangerMoves_m + kSigmasOfPlace * std::sqrt(variances_m2[marker]);
  double least = gate * gate;
  int nearest = -1;
  for (std::size_t k = 0; k < frame.cloud.size(); ++k) {
    const double square = (X_GC * frame.cloud[k].p_C - shape_G[marker]).squaredNorm();
    if (is_free[k] == 0 || square >= least) continue;
    least = square;
    nearest = static_cast<int>(k);
  }
  return nearest;
}

/// While a marker settles that has just come out of hiding, or when few were seen before, nothing tells a
/// jump from what the hiding hid.
bool SkinModel::Body::canTellJumps() const {
  const auto isSettled = [this](const SeenMarker& marker) {
    return filter.wasSeenJustNow(marker.marker) && filter.framesSeen(marker.marker) >= kFramesToSettle;
  };
  const auto markers = std::count(presence.present().begin(), presence.present().end(), 1);
  return std::all_of(seen.begin(), seen.end(), isSettled) &&
         static_cast<double>(seen.size()) >= kShareToTellJumps * static_cast<double>(markers);
}

void SkinModel::Body::takeJumps() {
  if (!canTellJumps()) return;
  for (SeenMarker& marker : seen) {
    const std::size_t i = marker.marker;
    const double sigma = std::sqrt(marker.covariance_m2.trace() / 3.0);
    if (slips.takesJump(i, marker.left_over, sigma, filter.expected(i), now)) marker.counts = false;
  }
}

void SkinModel::Body::learn(const SkinObservation& frame) {
  collect(frame);
  if (seen.size() < 3) return;
  filter.takeBodyMotionOff(seen);
  takeJumps();
  filter.learn(seen, target.markers_T, presence.present());
  slips.endFrame();
}

void SkinModel::Body::adaptRest(Seconds step) {
  filter.giveToRest(std::clamp(step / settings.adaptation_time, 0.0, 1.0), target.markers_T);
}

/// What is left of the cloud, near the body.
void SkinModel::Body::watchStrangers(const SkinObservation& frame) {
  const RigidTransform X_GC = (frame.X_CT * X_TG).inverse();
  strangers.begin(now, kStrangerMoves_m + kSigmasOfPlace * std::sqrt(filter.pooledVariance()));
  for (std::size_t k = 0; k < frame.cloud.size(); ++k)
    if (is_free[k] != 0) strangers.seen(X_GC * frame.cloud[k].p_C, frame.cloud[k].p_C);
  strangers.end();
}

/// Jumps that last become the rest shape: the sleeve has been laid anew.
bool SkinModel::Body::judgeSlips() {
  bool slipped = false;
  for (std::size_t i = 0; i < shape_G.size(); ++i) {
    const auto verdict = slips.judge(i, filter.deviations()[i], now);
    if (verdict == SlipWatch::Verdict::kNone) continue;
    if (verdict == SlipWatch::Verdict::kUndone)
      filter.add(i, slips.offset(i));
    else
      target.markers_T[i] += slips.offset(i);
    slipped = slipped || verdict == SlipWatch::Verdict::kLasts;
    slips.forget(i);
  }
  return slipped;
}

/// The stranger appeared about when the marker vanished.
bool SkinModel::Body::replaces(std::size_t marker, const Stranger& stranger) const {
  const Seconds gap = presence.missing(marker) - (now - stranger.first_seen);
  return std::abs(gap.count()) <= kSlipTakes.count();
}

/// The unseen marker whose place is nearest to a stranger that has stayed for the time of a slip, if that
/// is near enough; else as many as there are markers.
std::size_t SkinModel::Body::markerAt(const Stranger& stranger) const {
  const std::size_t none = shape_G.size();
  if (!stranger.alive || stranger.last_seen != now || now - stranger.first_seen < settings.slip_time)
    return none;
  double least = kSlipReach_m;
  std::size_t nearest = none;
  for (std::size_t i = 0; i < shape_G.size(); ++i) {
    const double distance = (shape_G[i] - stranger.last_T).norm();
    if (is_seen[i] != 0 || presence.present()[i] == 0 || distance >= least) continue;
    least = distance;
    nearest = i;
  }
  return nearest < none && (least < kStray_m || replaces(nearest, stranger)) ? nearest : none;
}

/// A stranger that stays beside the place of a marker that is not seen is that marker, out of the fit's
/// reach. When it appeared as the marker vanished the marker has slipped; else the skin has carried it there
/// while it was hidden, or so little is learnt yet that this cannot be told.
bool SkinModel::Body::takeUpStrays() {
  bool slipped = false;
  for (std::size_t k = 0; k < StrangerWatch::kMostStrangers; ++k) {
    const Stranger& stranger = strangers.strangers()[k];
    const std::size_t marker = markerAt(stranger);
    if (marker >= shape_G.size()) continue;
    const Vector3d moved = stranger.last_T - shape_G[marker];
    const bool is_slip =
        slips.isArmed() && replaces(marker, stranger) && filter.framesSeen(marker) >= kFramesToSettle;
    if (is_slip)
      target.markers_T[marker] += moved;
    else
      filter.add(marker, moved);
    slipped = slipped || is_slip;
    slips.forget(marker);
    strangers.forget(k);
    is_seen[marker] = 1;
  }
  return slipped;
}

/// Within the extent of the markers: no farther from the nearest one than the loneliest of them from its own.
bool SkinModel::Body::belongsToBody(const Stranger& stranger) const {
  double loneliest = 0.0, nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < shape_G.size(); ++i) {
    if (presence.present()[i] == 0) continue;
    double next = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < shape_G.size(); ++j)
      if (j != i) next = std::min(next, (shape_G[i] - shape_G[j]).norm());
    loneliest = std::max(loneliest, next);
    nearest = std::min(nearest, (shape_G[i] - stranger.last_T).norm());
  }
  return nearest > target.marker_diameter_m && nearest <= loneliest;
}

bool SkinModel::Body::addMarker() {
  if (target.markers_T.size() >= static_cast<std::size_t>(kMaxMarkers)) return false;
  double skin_m2 = 0.0;
  for (std::size_t i = 0; i < shape_G.size(); ++i) skin_m2 = std::max(skin_m2, filter.levelVariance(i));
  for (std::size_t k = 0; k < StrangerWatch::kMostStrangers; ++k) {
    const Stranger stranger = strangers.strangers()[k];
    if (stranger.last_seen != now || !StrangerWatch::movesWithBody(stranger, settings.adding_time, skin_m2) ||
        !belongsToBody(stranger))
      continue;
    target.markers_T.push_back(stranger.last_T);
    target.markers_covariance_m2.push_back(
        taughtAgain(Matrix3d::Zero(), stranger.scatter_T_m2 / (3.0 * stranger.frames * stranger.frames)));
    strangers.forget(k);
    resize();
    return true;
  }
  return false;
}

/// One event a frame, the weightiest.
SkinEvent SkinModel::Body::conclude(const SkinObservation& frame, Seconds step) {
  watchStrangers(frame);
  const bool found = presence.finds(is_seen);
  const bool lost = presence.loses(is_seen, frame.in_view, step);
  const bool jumped = judgeSlips();
  const bool slipped = takeUpStrays() || jumped;
  const bool added = addMarker();
  if (slipped || added) ++version;
  adaptRest(step);
  filter.predict(now);
  shapeFromParts();
  if (slipped) return SkinEvent::kSlipped;
  if (lost) return SkinEvent::kMarkerLost;
  if (found) return SkinEvent::kMarkerFound;
  return added ? SkinEvent::kMarkerAdded : SkinEvent::kNone;
}

SkinModel::SkinModel(const Target& taught, const SkinSettings& settings)
    : body_(std::make_unique<Body>(taught, settings)) {}

SkinModel::~SkinModel() = default;
SkinModel::SkinModel(SkinModel&&) noexcept = default;
SkinModel& SkinModel::operator=(SkinModel&&) noexcept = default;

void SkinModel::predict(TimePoint time) {
  body_->now = time;
  body_->filter.predict(time);
  body_->shapeFromParts();
}

SkinEvent SkinModel::observe(const SkinObservation& seen) {
  Body& body = *body_;
  const Seconds step(body.observed ? std::max(0.0, secondsBetween(body.filter.lastLearnt(), body.now)) : 0.0);
  body.observed = true;
  body.learn(seen);
  return body.conclude(seen, step);
}

SkinEvent SkinModel::observeMisfit(const SkinObservation& seen) {
  Body& body = *body_;
  const WideMatch::Body shape{body.shape_T, body.presence.present(), body.variances_m2};
  body.found_pose.reset();
  if (!body.wide.run(shape, seen.X_CT, seen.cloud, seen.taken)) return SkinEvent::kNone;
  body.found_pose = body.wide.pose();
  SkinObservation found = seen;
  found.X_CT = body.wide.pose();
  found.point_of_marker = body.wide.pointOfMarker();
  return observe(found);
}

const std::optional<RigidTransform>& SkinModel::foundPose() const { return body_->found_pose; }

std::span<const Vector3d> SkinModel::shape_T() const { return body_->shape_T; }
std::span<const Matrix3d> SkinModel::covariance_m2() const { return body_->covariance_m2; }
std::span<const char> SkinModel::present() const { return body_->presence.present(); }

double SkinModel::deviation_m() const {
  double square = 0.0;
  for (std::size_t i = 0; i < body_->shape_T.size(); ++i)
    square += (body_->shape_T[i] - body_->target.markers_T[i]).squaredNorm();
  return std::sqrt(square / static_cast<double>(std::max<std::size_t>(1, body_->shape_T.size())));
}

double SkinModel::tolerance_m() const {
  double square = 0.0;
  for (std::size_t i = 0; i < body_->shape_T.size(); ++i) square += body_->filter.levelVariance(i);
  return kToleranceSigmas *
         std::sqrt(2.0 * square / static_cast<double>(std::max<std::size_t>(1, body_->shape_T.size())));
}

const Target& SkinModel::target() const { return body_->target; }
int SkinModel::version() const { return body_->version; }

}  // namespace mirrorarm::tracking
