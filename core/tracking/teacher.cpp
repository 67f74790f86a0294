#include "core/tracking/teacher.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/geometry/rigid_fit.h"
#include "core/tracking/keyframes.h"
#include "core/tracking/layout.h"
#include "core/tracking/lesson_network.h"
#include "core/tracking/lesson_registration.h"
#include "core/tracking/running_model.h"

namespace mirrorarm::tracking {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kMinMarkers = 3;
constexpr double kGateInRms = 3.0;
constexpr int kPatience = 5;       // clouds that do not fit before a new beginning is thought of
constexpr int kFirstLook = 10;     // frames before the precision is looked at
constexpr double kNextLook = 1.2;  // times the frames of the last look
constexpr int kFramesBetweenLooks = 5;
constexpr int kStepsOfALook = 1;

}  // namespace

std::string_view id(TeachingError error) {
  switch (error) {
    case TeachingError::kNoFrames:
      return "no_frames";
    case TeachingError::kTooFewMarkers:
      return "too_few_markers";
    case TeachingError::kCollinear:
      return "collinear";
  }
  return "no_frames";
}

struct Teacher::Body {
  explicit Body(const TeacherSettings& chosen)
      : settings(chosen), registration(chosen.softassign, chosen.max_rms_m) {}

  TeacherSettings settings;
  RunningModel model;
  Keyframes keyframes;
  LessonRegistration registration;
  std::vector<CloudPoint> cloud;
  std::vector<Vector3d> places_C;
  int frames = 0;
  int rejected_in_a_row = 0;
  BundleAdjustment adjustment;
  double looked_sigma_m = std::numeric_limits<double>::infinity();
  int looked_at = 0;  ///< frames of the model at the last look

  void learn();
  void begin();
  void take(const RigidTransform& X_CT, double gate_m);
  void look();
  [[nodiscard]] bool isTimeToLook() const;
  [[nodiscard]] double sigma_m() const;
  [[nodiscard]] std::vector<RunningModel::Point> markers() const {
    return model.markers(settings.min_presence, settings.marker_diameter_m);
  }
};

void Teacher::Body::learn() {
  ++frames;
  if (rejected_in_a_row > std::max(kPatience, model.frames())) {
    model.clear();
    keyframes.clear();
  }
  if (model.frames() == 0) {
    begin();
    return;
  }
  const auto fit = registration.run(model.steadyPoints(), cloud);
  if (!fit) {
    ++rejected_in_a_row;
    return;
  }
  take(fit->X_CT, std::clamp(kGateInRms * fit->rms_m, settings.softassign.tolerated_distance_m,
                             kGateInRms * settings.max_rms_m));
  if (isTimeToLook()) look();
}

void Teacher::Body::begin() {
  places_C.clear();
  for (const auto& point : cloud) places_C.push_back(point.p_C);
  if (places_C.size() < kMinMarkers) return;
  const RigidTransform X_CT = makeTransform(Eigen::Matrix3d(Eigen::Matrix3d::Identity()), centroid(places_C));
  registration.begin(X_CT);
  looked_sigma_m = std::numeric_limits<double>::infinity();
  looked_at = 0;
  take(X_CT, settings.softassign.tolerated_distance_m);
}

void Teacher::Body::take(const RigidTransform& X_CT, double gate_m) {
  keyframes.add(X_CT, model.add(cloud, X_CT, gate_m));
  rejected_in_a_row = 0;
}

bool Teacher::Body::isTimeToLook() const {
  const int now = model.frames();
  if (now < kFirstLook) return false;
  if (now >= kNextLook * looked_at) return true;
  const bool hopeful = looked_sigma_m > settings.wanted_sigma_m && sigma_m() <= settings.wanted_sigma_m;
  return hopeful && now >= looked_at + kFramesBetweenLooks;
}

/// How sure the markers are by now; poses and positions go on from the adjusted ones.
void Teacher::Body::look() {
  looked_at = model.frames();
  looked_sigma_m = std::numeric_limits<double>::infinity();
  const auto points = markers();
  if (points.size() < kMinMarkers) return;
  auto lesson = networkOf(points, keyframes.all());
  if (areCollinear(lesson.network.markers_T)) return;
  adjustment.adjust(lesson.network, kStepsOfALook);
  for (std::size_t i = 0; i < points.size(); ++i)
    model.correct(points[i].id, lesson.network.markers_T[i], lesson.network.spread_m[i]);
  for (std::size_t f = 0; f < lesson.keyframe.size(); ++f)
    keyframes.correct(lesson.keyframe[f], lesson.network.frames[f].X_CT);
  looked_sigma_m = largestSigma(adjustment, points.size());
}

/// That of the last look, less what the frames since have told.
double Teacher::Body::sigma_m() const {
  if (looked_at == 0) return looked_sigma_m;
  return looked_sigma_m * std::sqrt(static_cast<double>(looked_at) / model.frames());
}

Teacher::Teacher(const TeacherSettings& settings) : body_(std::make_unique<Body>(settings)) {}
Teacher::~Teacher() = default;
Teacher::Teacher(Teacher&&) noexcept = default;
Teacher& Teacher::operator=(Teacher&&) noexcept = default;

void Teacher::add(std::span<const CloudPoint> cloud) {
  body_->cloud.clear();
  for (const auto& point : cloud) {
    if (body_->cloud.size() == kMaxPoints) break;
    if (point.p_C.allFinite() && point.covariance_m2.allFinite()) body_->cloud.push_back(point);
  }
  body_->learn();
}

void Teacher::add(std::span<const Vector3d> cloud_C) {
  body_->cloud.clear();
  for (const auto& p_C : cloud_C) {
    if (body_->cloud.size() == kMaxPoints) break;
    if (p_C.allFinite()) body_->cloud.push_back({p_C, Eigen::Matrix3d::Zero(), {}});
  }
  body_->learn();
}

int Teacher::frames() const { return body_->frames; }
int Teacher::markers() const { return static_cast<int>(body_->markers().size()); }
double Teacher::sigma_m() const { return body_->sigma_m(); }

bool Teacher::isDone() const {
  return body_->model.frames() >= body_->settings.min_frames &&
         body_->looked_sigma_m <= body_->settings.wanted_sigma_m;
}

Expected<TaughtTarget, TeachingError> Teacher::finish(std::string_view name) const {
  if (frames() == 0) return unexpected(TeachingError::kNoFrames);
  const auto points = body_->markers();
  if (points.size() < kMinMarkers) return unexpected(TeachingError::kTooFewMarkers);
  auto lesson = networkOf(points, body_->keyframes.all());
  auto& network = lesson.network;
  if (areCollinear(network.markers_T)) return unexpected(TeachingError::kCollinear);
  BundleAdjustment adjustment;
  adjustment.adjust(network);

  TaughtTarget taught;
  taught.frames_used = body_->model.frames();
  taught.frames_rejected = body_->frames - taught.frames_used;
  taught.target.name = name;
  taught.target.marker_diameter_m = body_->settings.marker_diameter_m;
  const Vector3d origin = centroid(network.markers_T);
  for (const auto& p : network.markers_T) taught.target.markers_T.push_back(p - origin);
  taught.skin_sigma_m = skinSigmas(network);
  const bool is_known = network.frames.size() > 1 || body_->cloud.front().covariance_m2.trace() > 0.0;
  if (!is_known) return taught;
  for (std::size_t i = 0; i < points.size(); ++i)
    taught.target.markers_covariance_m2.push_back(adjustment.covarianceOf(i));
  taught.sigma_m = largestSigma(adjustment, points.size());
  return taught;
}

}  // namespace mirrorarm::tracking
