#include "core/tracking/lesson_registration.h"

#include <algorithm>
#include <cmath>

namespace mirrorarm::tracking {
namespace {

constexpr int kEnough = 4;                 // markers that a fit needs, if there are so many
constexpr double kLeastShare = 0.45;       // of the points that are likely to be seen
constexpr double kSafeShare = 0.6;         // with fewer a look elsewhere is worth its time
constexpr double kFirstSpread_m = 0.0005;  // of a point seen once: skin moves
constexpr double kSearchTolerance_m = 0.001;
// Between two frames an arm departs from its motion by so much, and by a share of it.
constexpr double kShift_m = 0.004, kTurn_rad = 0.03, kShareOfStep = 0.5;
constexpr double kFoundShift_m = 0.0005, kFoundTurn_rad = 0.01;

UncertainPose uncertain(const RigidTransform& X_CT, double turn_rad, double shift_m) {
  UncertainPose pose{X_CT, Eigen::Matrix<double, 6, 6>::Zero()};
  pose.covariance.diagonal().head<3>().setConstant(turn_rad * turn_rad);
  pose.covariance.diagonal().tail<3>().setConstant(shift_m * shift_m);
  return pose;
}

WarmSettings settingsOf(const SoftassignSettings& softassign, double max_rms_m) {
  WarmSettings settings;
  settings.softassign = softassign;
  settings.max_rms_m = max_rms_m;
  return settings;
}

}  // namespace

LessonRegistration::LessonRegistration(const SoftassignSettings& softassign, double max_rms_m)
    : settings_(settingsOf(softassign, max_rms_m)), warm_(settings_) {}

void LessonRegistration::begin(const RigidTransform& X_CT) {
  X_CT_ = X_CT;
  step_T_ = RigidTransform::Identity();
}

std::optional<LessonRegistration::Fit> LessonRegistration::run(std::span<const RunningModel::Point> points,
                                                               std::span<const CloudPoint> cloud) {
  describe(points);
  const Shape shape{markers_T_, covariance_m2_, {}};
  const auto known = static_cast<double>(points.size());
  const int needed =
      static_cast<int>(std::max(std::min<double>(kEnough, known), std::ceil(kLeastShare * known)));
  const ShapeFit* fit = &warm_.run(shape, cloud, expected());
  if (!fit->isAccepted() || fit->matched < kSafeShare * known) {
    const SearchResult& found = search(cloud);
    if (found.verdict == SearchVerdict::kFound && (!fit->isAccepted() || found.best.matched > fit->matched))
      fit = &warm_.run(shape, cloud, uncertain(found.best.X_CT, kFoundTurn_rad, kFoundShift_m));
  }
  if (!fit->isAccepted() || fit->matched < needed) return std::nullopt;
  step_T_ = X_CT_.inverse() * fit->pose.X_CT;
  X_CT_ = fit->pose.X_CT;
  return Fit{X_CT_, fit->pose.rms_m};
}

/// Where each point is expected in T, and how sure that is: its own scatter and how seldom it was seen.
void LessonRegistration::describe(std::span<const RunningModel::Point> points) {
  markers_T_.clear();
  covariance_m2_.clear();
  for (const auto& point : points) {
    markers_T_.push_back(point.mean_T);
    covariance_m2_.push_back(
        (point.scatter_m2 + kFirstSpread_m * kFirstSpread_m * Eigen::Matrix3d::Identity()) / point.seen);
  }
}

UncertainPose LessonRegistration::expected() const {
  const double turn = rotationVector(step_T_.linear()).norm();
  return uncertain(X_CT_ * step_T_, kTurn_rad + kShareOfStep * turn,
                   kShift_m + kShareOfStep * step_T_.translation().norm());
}

const SearchResult& LessonRegistration::search(std::span<const CloudPoint> cloud) {
  const std::span<const Eigen::Vector3d> target = markers_T_;
  search_.setTargets({&target, 1}, {&kSearchTolerance_m, 1});
  return search_.run(cloud).front();
}

}  // namespace mirrorarm::tracking
