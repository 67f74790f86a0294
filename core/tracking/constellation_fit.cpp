#include "core/tracking/constellation_fit.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "core/geometry/dual_quaternion.h"
#include "core/geometry/rigid_fit.h"
#include "core/tracking/layout.h"

namespace mirrorarm::tracking {
namespace {

using Eigen::Vector3d;

constexpr int kMostRounds = 4;
constexpr double kStrainSigmas = 4.0;

/// Largest misfit that is not strange for so many markers.
double usualMisfit(std::size_t matched) {
  const double freedom = 3.0 * static_cast<double>(matched) - 6.0;
  return freedom + kStrainSigmas * std::sqrt(2.0 * freedom);
}

}  // namespace

double Gate::share(const SearchCloud& cloud, int point, const Vector3d& off_m) const {
  const double distance_m = off_m.norm();
  if (!(distance_m > 0.0)) return 0.0;
  return distance_m / (tolerance_m + sigmas * cloud.sigmaAlong(point, off_m));
}

void ConstellationFit::begin(std::span<const Vector3d> markers_T, const SearchCloud& cloud,
                             std::span<const char> free, const Gate& gate) {
  markers_T_ = markers_T;
  cloud_ = &cloud;
  free_ = free;
  gate_ = gate;
}

bool ConstellationFit::run(std::span<const Pairing> pairings, int least, Constellation& fit) {
  pairings_.assign(pairings.begin(), pairings.end());
  solve(fit);
  leaveOutMisfits(least, fit);
  for (int round = 0; round < kMostRounds && static_cast<int>(pairings_.size()) >= least; ++round) {
    const bool is_settled = !gather(fit);
    if (static_cast<int>(pairings_.size()) < least || is_settled) break;
    solve(fit);
  }
  leaveOutStrain(least, fit);
  if (static_cast<int>(pairings_.size()) < least || !fixesPose()) return false;
  conclude(fit);
  return true;
}

void ConstellationFit::solve(Constellation& fit) {
  x_.clear();
  y_.clear();
  weights_.clear();
  for (const Pairing& one : pairings_) {
    x_.push_back(markers_T_[static_cast<std::size_t>(one.marker)]);
    y_.push_back(cloud_->at(one.point));
    weights_.push_back(1.0 / (cloud_->variance(one.point) + gate_.modelVariance()));
  }
  fit.X_CT = fitByDualQuaternion(x_, y_, weights_);
}

/// One at a time, the worst first, until all fit or too few are left.
void ConstellationFit::leaveOutMisfits(int least, Constellation& fit) {
  while (static_cast<int>(pairings_.size()) >= least) {
    const auto share = [&](const Pairing& one) { return gate_.share(*cloud_, one.point, offset(fit, one)); };
    const auto worst = std::ranges::max_element(pairings_, {}, share);
    if (share(*worst) <= 1.0) return;
    pairings_.erase(worst);
    if (static_cast<int>(pairings_.size()) >= least) solve(fit);
  }
}

/// Pairs all markers anew with the points in their gates, the best fitting first; true when that changed any.
bool ConstellationFit::gather(Constellation& fit) {
  candidates_.clear();
  for (int marker = 0; marker < static_cast<int>(markers_T_.size()); ++marker) {
    const Vector3d expected_C = fit.X_CT * markers_T_[static_cast<std::size_t>(marker)];
    for (int point = 0; point < cloud_->size(); ++point) {
      const Vector3d off_m = cloud_->at(point) - expected_C;
      if (!gate_.mayReach(*cloud_, point, off_m) || free_[static_cast<std::size_t>(point)] == 0) continue;
      const double share = gate_.share(*cloud_, point, off_m);
      if (share <= 1.0) candidates_.push_back({share, {marker, point}});
    }
  }
  std::ranges::sort(candidates_, {}, &Candidate::share);
  gathered_.clear();
  for (const auto& [share, next] : candidates_) {
    const bool clashes = std::ranges::any_of(gathered_, [&](const Pairing& one) {
      return one.marker == next.marker || one.point == next.point ||
             shareADisc((*cloud_)[one.point].discs, (*cloud_)[next.point].discs);
    });
    if (!clashes) gathered_.push_back(next);
  }
  std::ranges::sort(gathered_, {}, &Pairing::marker);
  std::ranges::sort(pairings_, {}, &Pairing::marker);
  const bool changed = !std::ranges::equal(gathered_, pairings_, [](const Pairing& a, const Pairing& b) {
    return a.marker == b.marker && a.point == b.point;
  });
  pairings_.swap(gathered_);
  return changed;
}

/// A fit that is worse than noise explains, but would be good without one of its pairings, is without it.
void ConstellationFit::leaveOutStrain(int least, Constellation& fit) {
  const std::size_t all = pairings_.size();
  if (static_cast<int>(all) <= least || all <= 3 || misfitOf(fit) <= usualMisfit(all)) return;
  const RigidTransform X_CT = fit.X_CT;
  gathered_ = pairings_;
  std::size_t worst = all;
  double least_misfit = usualMisfit(all - 1);
  for (std::size_t i = 0; i < all; ++i) {
    pairings_.erase(pairings_.begin() + static_cast<std::ptrdiff_t>(i));
    solve(fit);
    if (const double misfit = misfitOf(fit); misfit < least_misfit) {
      least_misfit = misfit;
      worst = i;
    }
    pairings_ = gathered_;
  }
  fit.X_CT = X_CT;
  if (worst == all) return;
  pairings_.erase(pairings_.begin() + static_cast<std::ptrdiff_t>(worst));
  solve(fit);
}

double ConstellationFit::misfitOf(const Constellation& fit) const {
  double misfit = 0.0;
  for (const Pairing& one : pairings_) {
    const Vector3d off = offset(fit, one);
    const Eigen::Matrix3d covariance =
        (*cloud_)[one.point].covariance_m2 + gate_.modelVariance() * Eigen::Matrix3d::Identity();
    misfit += off.dot(covariance.inverse() * off);
  }
  return misfit;
}

void ConstellationFit::conclude(Constellation& fit) const {
  fit.point_of_marker.assign(markers_T_.size(), -1);
  fit.matched = static_cast<int>(pairings_.size());
  fit.misfit = misfitOf(fit);
  double square = 0.0;
  for (const Pairing& one : pairings_) {
    fit.point_of_marker[static_cast<std::size_t>(one.marker)] = one.point;
    square += offset(fit, one).squaredNorm();
  }
  fit.rms_m = std::sqrt(square / fit.matched);
}

bool ConstellationFit::fixesPose() {
  x_.clear();
  for (const Pairing& one : pairings_) x_.push_back(markers_T_[static_cast<std::size_t>(one.marker)]);
  return !areCollinear(x_);
}

}  // namespace mirrorarm::tracking
