#include "core/tracking/registration.h"

#include <algorithm>

#include "core/geometry/dual_quaternion.h"
#include "core/geometry/rigid_fit.h"
#include "core/tracking/layout.h"

namespace mirrorarm::tracking {
namespace {

using Eigen::Vector3d;
using Points = std::span<const Vector3d>;

constexpr int kMinForPose = 3;
constexpr int kMaxSettlingRounds = 10;
constexpr double kGateInRms = 3.0;
constexpr double kMinUncertainty_m = 0.003;
// A good guess leaves few candidates: the annealing may hasten.
constexpr double kWarmBetaFactor = 1.5;

SoftassignSettings scheduleFor(const RegistrationSettings& settings, double uncertainty_m) {
  SoftassignSettings schedule = settings.softassign;
  if (settings.full_schedule) return schedule;
  const double spread_mm = 1e3 * std::max(uncertainty_m, kMinUncertainty_m);
  schedule.beta_start = std::max(schedule.beta_start, 0.5 / (spread_mm * spread_mm));
  schedule.beta_factor = std::max(schedule.beta_factor, kWarmBetaFactor);
  return schedule;
}

bool isBetter(const RegistrationResult& a, const RegistrationResult& b) {
  if (a.isAccepted() != b.isAccepted()) return a.isAccepted();
  return a.matched != b.matched ? a.matched > b.matched : a.rms_m < b.rms_m;
}

}  // namespace

const RegistrationResult& Registration::follow(Points x, Points y, const RegistrationSettings& settings,
                                               const RigidTransform& guess_YX, double uncertainty_m) {
  const auto& first = softassign_.run(x, y, scheduleFor(settings, uncertainty_m), guess_YX);
  result_.X_YX = first.X_YX;
  result_.y_of_x = first.y_of_x;
  result_.matched = first.matched;
  result_.rms_m = first.rms_m;
  settle(x, y, settings);
  return result_;
}

const RegistrationResult& Registration::search(Points x, Points y, const RegistrationSettings& settings) {
  best_ = {};
  best_.reason = y.empty() ? LostReason::kNoPoints : LostReason::kTooFewMarkers;
  best_.y_of_x.assign(x.size(), -1);
  const TripleSearchSettings triples{.tolerance_m = settings.max_rms_m, .gate_m = 2.0 * settings.max_rms_m};
  for (const auto& pose : triples_.run(x, y, triples)) {
    start(x, y, pose.X_YX, triples.gate_m);
    settle(x, y, settings);
    if (isBetter(result_, best_)) best_ = result_;
  }
  if (best_.matched >= kMinForPose && isBetter(follow(x, y, settings, best_.X_YX, settings.max_rms_m), best_))
    best_ = result_;
  if (!best_.isAccepted() && triples_.wasCutOff()) best_.reason = LostReason::kNotConverged;
  return best_;
}

/// Takes the nearest pairs under the guess for a beginning.
void Registration::start(Points x, Points y, const RigidTransform& guess_YX, double gate_m) {
  result_.matched = association_.pair(x, y, guess_YX, gate_m, result_.y_of_x, discs_of_y_);
  result_.X_YX = guess_YX;
  result_.rms_m = gate_m;
}

/// Pairs and pose in turn until the pairs stay; then the verdict.
void Registration::settle(Points x, Points y, const RegistrationSettings& settings) {
  result_.reason = y.empty() ? LostReason::kNoPoints : LostReason::kTooFewMarkers;
  for (int round = 0; round < kMaxSettlingRounds && result_.matched >= kMinForPose; ++round) {
    const double gate_m = std::clamp(kGateInRms * result_.rms_m, settings.softassign.tolerated_distance_m,
                                     kGateInRms * settings.max_rms_m);
    y_of_x_before_ = result_.y_of_x;
    result_.matched = association_.pair(x, y, result_.X_YX, gate_m, result_.y_of_x, discs_of_y_);
    if (result_.matched >= kMinForPose) fit(x, y);
    if (result_.y_of_x == y_of_x_before_) break;
  }
  if (result_.matched < std::max(settings.min_matched, kMinForPose)) return;
  dropWorstPairs(x, y, settings);
  if (result_.rms_m > settings.max_rms_m) {
    result_.reason = LostReason::kBadFit;
  } else if (!areCollinear(x_part_)) {
    result_.reason = LostReason::kNone;
  }
}

void Registration::fit(Points x, Points y) {
  x_part_.clear();
  y_part_.clear();
  for (std::size_t j = 0; j < x.size(); ++j) {
    if (result_.y_of_x[j] < 0) continue;
    x_part_.push_back(x[j]);
    y_part_.push_back(y[static_cast<std::size_t>(result_.y_of_x[j])]);
  }
  even_.assign(x_part_.size(), 1.0);
  result_.X_YX = fitByDualQuaternion(x_part_, y_part_, even_);
  result_.rms_m = fitRms(result_.X_YX, x_part_, y_part_);
}

/// A marker that slipped must not cost the whole frame, as long as enough others fit.
void Registration::dropWorstPairs(Points x, Points y, const RegistrationSettings& settings) {
  const int required = std::max(settings.min_matched, kMinForPose);
  while (result_.rms_m > settings.max_rms_m && result_.matched > required) {
    double largest = -1.0;
    std::size_t worst = 0;
    for (std::size_t j = 0; j < x.size(); ++j) {
      if (result_.y_of_x[j] < 0) continue;
      const double misfit =
          (y[static_cast<std::size_t>(result_.y_of_x[j])] - result_.X_YX * x[j]).squaredNorm();
      if (misfit <= largest) continue;
      largest = misfit;
      worst = j;
    }
    result_.y_of_x[worst] = -1;
    --result_.matched;
    fit(x, y);
  }
}

}  // namespace mirrorarm::tracking
