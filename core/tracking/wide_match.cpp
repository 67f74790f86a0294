#include "core/tracking/wide_match.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/small_motion.h"
#include "core/tracking/tracked_target.h"

namespace mirrorarm::tracking {
namespace {

using Eigen::Vector3d;

constexpr double kSkinMoves_m = 0.020;
constexpr double kGates_m[] = {0.025, 0.020, 0.015, 0.010};  // round by round, neighbours being followed
constexpr double kNeighbour_m = 0.040;
constexpr double kCrude_m2 = 0.002 * 0.002;  // of a first match
constexpr double kLeastShare = 0.4;          // of the markers that must be found
constexpr int kLeastFound = 4;
constexpr double kBetaFactor = 1.5;
constexpr int kStepsARound = 2;

}  // namespace

bool WideMatch::run(const Body& body, const RigidTransform& X_CT, std::span<const CloudPoint> cloud,
                    std::span<const char> taken) {
  X_CT_ = X_CT;
  collect(body, cloud, taken);
  const double needed = std::max<double>(kLeastFound, kLeastShare * static_cast<double>(markers_.size()));
  assignSoftly();
  for (const double gate_m : kGates_m) {
    pair(gate_m);
    if (static_cast<double>(seen_.size()) < needed) return false;
    for (int step = 0; step < kStepsARound; ++step) fit(body);
    followNeighbours(body);
  }
  double square = 0.0;
  point_of_marker_.assign(body.shape_T.size(), -1);
  for (std::size_t i = 0; i < pairs_.size(); ++i)
    if (pairs_[i] >= 0)
      point_of_marker_[markers_[i]] = static_cast<int>(points_[static_cast<std::size_t>(pairs_[i])]);
  for (const SeenMarker& marker : seen_) square += marker.left_over.squaredNorm();
  return square < kSkinMoves_m * kSkinMoves_m * static_cast<double>(seen_.size());
}

void WideMatch::collect(const Body& body, std::span<const CloudPoint> cloud, std::span<const char> taken) {
  markers_.clear();
  points_.clear();
  places_T_.clear();
  points_C_.clear();
  discs_.clear();
  for (std::size_t i = 0; i < body.shape_T.size(); ++i) {
    if (body.present[i] == 0) continue;
    markers_.push_back(i);
    places_T_.push_back(body.shape_T[i]);
  }
  for (std::size_t k = 0; k < cloud.size() && points_.size() < kMaxPoints; ++k) {
    const bool near =
        taken[k] == 0 && std::any_of(places_T_.begin(), places_T_.end(), [&](const Vector3d& p) {
          return (X_CT_ * p - cloud[k].p_C).squaredNorm() < 4.0 * kSkinMoves_m * kSkinMoves_m;
        });
    if (!near) continue;
    points_.push_back(k);
    points_C_.push_back(cloud[k].p_C);
    discs_.push_back(cloud[k].discs);
  }
}

/// The paper's correspondences decide all together, for the nearest point may be a neighbour's.
void WideMatch::assignSoftly() {
  SoftassignSettings wide;
  wide.tolerated_distance_m = kSkinMoves_m;
  constexpr double kSkinMoves_mm = 1e3 * kSkinMoves_m;
  wide.beta_start = 0.5 / (kSkinMoves_mm * kSkinMoves_mm);
  wide.beta_factor = kBetaFactor;
  X_CT_ = softassign_.run(places_T_, points_C_, wide, X_CT_).X_YX;
}

void WideMatch::pair(double gate_m) {
  association_.pair(places_T_, points_C_, X_CT_, gate_m, pairs_, discs_);
  seen_.clear();
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    if (pairs_[i] < 0) continue;
    SeenMarker marker;
    marker.marker = i;
    seen_.push_back(marker);
  }
}

/// The pose by the shape as it was, not as the neighbours have moved it.
void WideMatch::fit(const Body& body) {
  none_.resize(body.shape_T.size());
  const RigidTransform X_TC = X_CT_.inverse();
  for (SeenMarker& marker : seen_) {
    const std::size_t i = marker.marker;
    marker.place_T = body.shape_T[markers_[i]];
    marker.innovation = X_TC * points_C_[static_cast<std::size_t>(pairs_[i])] - marker.place_T;
    marker.covariance_m2 = (body.variances_m2[markers_[i]] + kCrude_m2) * Eigen::Matrix3d::Identity();
  }
  fit_.run(seen_, none_, {});
  X_CT_ = X_CT_ * smallMotion(fit_.motion());
}

void WideMatch::followNeighbours(const Body& body) {
  for (std::size_t i = 0; i < markers_.size(); ++i) {
    const Vector3d& place_T = body.shape_T[markers_[i]];
    Vector3d moved = Vector3d::Zero();
    double weights = 0.0;
    for (const SeenMarker& other : seen_) {
      const double distance = (other.place_T - place_T).norm() / kNeighbour_m;
      const double weight = std::exp(-0.5 * distance * distance);
      moved += weight * other.left_over;
      weights += weight;
    }
    places_T_[i] = weights > 0.0 ? Vector3d(place_T + moved / weights) : place_T;
  }
}

}  // namespace mirrorarm::tracking
