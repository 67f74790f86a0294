#include "core/tracking/softassign.h"

#include <algorithm>
#include <cassert>

#include "core/geometry/dual_quaternion.h"
#include "core/geometry/rigid_fit.h"

namespace mirrorarm::tracking {
namespace {

using Eigen::Vector3d;
using Points = std::span<const Vector3d>;

constexpr double kMm2PerM2 = 1e6;
constexpr double kDecided = 1e-6;       // entries this near to 0 and 1 are decided
constexpr double kPoseAtRest_m = 1e-5;  // an update that moves the model less than this has converged
constexpr double kNoWeight = 1e-12;

double largestShift(Points points, const RigidTransform& from, const RigidTransform& to) {
  double largest = 0.0;
  for (const auto& p : points) largest = std::max(largest, (to * p - from * p).squaredNorm());
  return std::sqrt(largest);
}

}  // namespace

const SoftassignResult& Softassign::run(Points x, Points y, const SoftassignSettings& settings,
                                        const std::optional<RigidTransform>& start) {
  result_.X_YX = start.value_or(RigidTransform::Identity());
  result_.y_of_x.assign(x.size(), -1);
  result_.matched = 0;
  result_.rms_m = 0.0;
  if (x.empty() || y.empty()) return result_;
  if (!start) result_.X_YX.translation() = centroid(y) - centroid(x);
  match_.reset(static_cast<Eigen::Index>(x.size()), static_cast<Eigen::Index>(y.size()));
  Q_mm2_.resize(static_cast<Eigen::Index>(x.size()), static_cast<Eigen::Index>(y.size()));
  anneal(x, y, settings);
  decide(x, y);
  return result_;
}

void Softassign::anneal(Points x, Points y, const SoftassignSettings& settings) {
  assert(settings.beta_start > 0.0 && settings.beta_factor > 1.0);
  const double alpha_mm2 = kMm2PerM2 * settings.tolerated_distance_m * settings.tolerated_distance_m;
  for (double beta = settings.beta_start; beta <= settings.beta_max; beta *= settings.beta_factor) {
    bool at_rest = false;
    for (int update = 0; update < settings.max_mutual_updates && !at_rest; ++update)
      at_rest = updateMutually(x, y, beta, alpha_mm2);
    if (at_rest && match_.isBinary(kDecided)) return;
  }
}

/// One correspondence and one pose update; true when the pose has come to rest.
bool Softassign::updateMutually(Points x, Points y, double beta, double alpha_mm2) {
  assign(x, y, beta, alpha_mm2);
  const RigidTransform before = result_.X_YX;
  return !estimatePose(x, y) || largestShift(x, before, result_.X_YX) < kPoseAtRest_m;
}

void Softassign::assign(Points x, Points y, double beta, double alpha_mm2) {
  for (std::size_t j = 0; j < x.size(); ++j) {
    const Vector3d moved = result_.X_YX * x[j];
    for (std::size_t k = 0; k < y.size(); ++k)
      Q_mm2_(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(k)) =
          kMm2PerM2 * (y[k] - moved).squaredNorm() - alpha_mm2;
  }
  match_.assign(Q_mm2_, beta);
}

// Summed over k, the soft pairs of one model point pull like a single pair with their common weight at their
// weighted mean: the same minimum as equation 31 with J instead of J * K terms.
bool Softassign::estimatePose(Points x, Points y) {
  x_part_.clear();
  y_part_.clear();
  weight_.clear();
  for (std::size_t j = 0; j < x.size(); ++j) {
    const auto row = match_.weights().row(static_cast<Eigen::Index>(j));
    const double weight = row.sum();
    if (!(weight > kNoWeight)) continue;
    Vector3d mean = Vector3d::Zero();
    for (std::size_t k = 0; k < y.size(); ++k) mean += row[static_cast<Eigen::Index>(k)] * y[k];
    x_part_.push_back(x[j]);
    y_part_.push_back(mean / weight);
    weight_.push_back(weight);
  }
  if (weight_.empty()) return false;
  result_.X_YX = fitByDualQuaternion(x_part_, y_part_, weight_);
  return true;
}

/// From shares to one-to-one pairs, and the plain least-squares pose over them.
void Softassign::decide(Points x, Points y) {
  taken_.assign(y.size(), 0);
  x_part_.clear();
  y_part_.clear();
  for (std::size_t j = 0; j < x.size(); ++j) {
    Eigen::Index best = 0;
    const double share = match_.weights().row(static_cast<Eigen::Index>(j)).maxCoeff(&best);
    const auto k = static_cast<std::size_t>(best);
    if (taken_[k] != 0 || share < match_.slack()[static_cast<Eigen::Index>(j)]) continue;
    taken_[k] = 1;
    result_.y_of_x[j] = static_cast<int>(k);
    x_part_.push_back(x[j]);
    y_part_.push_back(y[k]);
  }
  result_.matched = static_cast<int>(x_part_.size());
  if (result_.matched == 0) return;
  weight_.assign(x_part_.size(), 1.0);
  if (result_.matched >= 3) result_.X_YX = fitByDualQuaternion(x_part_, y_part_, weight_);
  result_.rms_m = fitRms(result_.X_YX, x_part_, y_part_);
}

SoftassignResult registerSoftassign(Points x, Points y, const SoftassignSettings& settings,
                                    const std::optional<RigidTransform>& start) {
  return Softassign().run(x, y, settings, start);
}

}  // namespace mirrorarm::tracking
