#include "core/tracking/teacher.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Eigenvalues>

#include "core/tracking/layout.h"
#include "core/tracking/registration.h"
#include "core/tracking/running_model.h"

namespace mirrorarm::tracking {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr std::size_t kMinMarkers = 3;
constexpr int kMinForRegistration = 4;
constexpr double kModelPresence = 0.5;  // points that later clouds are registered to
constexpr double kStep_m = 0.03;        // an arm's way from frame to frame
constexpr double kGateInRms = 3.0;

Vector3d centroid(std::span<const Vector3d> points) {
  Vector3d sum = Vector3d::Zero();
  for (const auto& p : points) sum += p;
  return sum / static_cast<double>(points.size());
}

/// Covariance of a mean of `seen` readings.
Matrix3d covarianceOfMean(const RunningModel::Point& point) {
  const double seen = point.seen;
  return point.scatter_m2 / std::max(1.0, seen * (seen - 1.0));
}

double largestSigma(const Matrix3d& covariance) {
  Eigen::SelfAdjointEigenSolver<Matrix3d> solver;
  solver.computeDirect(covariance, Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(0.0, solver.eigenvalues()[2]));
}

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
  TeacherSettings settings;
  RunningModel model;
  RigidTransform X_CT = RigidTransform::Identity();  ///< at the last cloud that fitted
  int rejected = 0;
  Registration registration;
  std::vector<Vector3d> cloud_C, model_T;

  void collect(std::span<const Vector3d> cloud);
  void begin();
  void registerCloud();
  [[nodiscard]] const RegistrationResult& locate(const RegistrationSettings& needed);
};

void Teacher::Body::collect(std::span<const Vector3d> cloud) {
  cloud_C.clear();
  for (const auto& p : cloud)
    if (p.allFinite() && cloud_C.size() < kMaxPoints) cloud_C.push_back(p);
}

void Teacher::Body::begin() {
  if (cloud_C.size() < kMinMarkers) {
    ++rejected;
    return;
  }
  X_CT.translation() = centroid(cloud_C);
  model.add(cloud_C, X_CT, settings.softassign.tolerated_distance_m);
}

void Teacher::Body::registerCloud() {
  model_T.clear();
  for (const auto& point : model.markers(kModelPresence, 0.0)) model_T.push_back(point.mean_T);
  const auto known = static_cast<int>(model_T.size());
  const int needed = std::max(std::min(kMinForRegistration, known), (model.steadyCount() + 1) / 2);
  const auto& fit = locate({settings.softassign, false, settings.max_rms_m, needed});
  if (!fit.isAccepted()) {
    ++rejected;
    return;
  }
  X_CT = fit.X_YX;
  model.add(cloud_C, X_CT,
            std::clamp(kGateInRms * fit.rms_m, settings.softassign.tolerated_distance_m,
                       kGateInRms * settings.max_rms_m));
}

/// From the last pose if that will do, else from nothing.
const RegistrationResult& Teacher::Body::locate(const RegistrationSettings& needed) {
  const auto& near = registration.follow(model_T, cloud_C, needed, X_CT, kStep_m);
  return near.isAccepted() ? near : registration.search(model_T, cloud_C, needed);
}

Teacher::Teacher(const TeacherSettings& settings) : body_(std::make_unique<Body>()) {
  body_->settings = settings;
}

Teacher::~Teacher() = default;
Teacher::Teacher(Teacher&&) noexcept = default;
Teacher& Teacher::operator=(Teacher&&) noexcept = default;

void Teacher::add(std::span<const Vector3d> cloud_C) {
  body_->collect(cloud_C);
  if (body_->model.frames() == 0) {
    body_->begin();
  } else {
    body_->registerCloud();
  }
}

int Teacher::frames() const { return body_->model.frames() + body_->rejected; }

int Teacher::markers() const {
  const auto& settings = body_->settings;
  return static_cast<int>(body_->model.markers(settings.min_presence, settings.marker_diameter_m).size());
}

Expected<TaughtTarget, TeachingError> Teacher::finish(std::string_view name) const {
  if (frames() == 0) return unexpected(TeachingError::kNoFrames);
  const auto& settings = body_->settings;
  const auto points = body_->model.markers(settings.min_presence, settings.marker_diameter_m);
  if (points.size() < kMinMarkers) return unexpected(TeachingError::kTooFewMarkers);

  TaughtTarget taught;
  taught.frames_used = body_->model.frames();
  taught.frames_rejected = body_->rejected;
  taught.target.name = name;
  taught.target.marker_diameter_m = settings.marker_diameter_m;
  auto& markers_T = taught.target.markers_T;
  for (const auto& point : points) markers_T.push_back(point.mean_T);
  if (areCollinear(markers_T)) return unexpected(TeachingError::kCollinear);
  const Vector3d origin = centroid(markers_T);
  for (auto& p : markers_T) p -= origin;
  if (taught.frames_used < 2) return taught;
  for (const auto& point : points) {
    taught.target.markers_covariance_m2.push_back(covarianceOfMean(point));
    taught.sigma_m = std::max(taught.sigma_m, largestSigma(taught.target.markers_covariance_m2.back()));
  }
  return taught;
}

}  // namespace mirrorarm::tracking
