#include "core/tracking/target_search.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/tracking/layout.h"

namespace mirrorarm::tracking {
namespace {

using Eigen::Vector3d;

constexpr int kLeastMarkers = 4;
// Three markers prove nothing where there is a choice of points.
constexpr int kMostPointsForThree = 5;
// What a rigid fit costs, in steps of the clique search.
constexpr int kStepsOfAFit = 20;
constexpr int kPairingsOfAStep = 16;
// A point that lies this many gates from its marker belongs to another pose.
constexpr double kGatesOfAPose = 2.0;
// A triangle leaves its pose so uncertain that a further marker sweeps a ball of so many
// widths of a distance; the number makes the formula agree with counted fits.
constexpr double kSweptWidths = 1.8;

// How many degrees of freedom the belief that misfits are as large as they should be is worth.
constexpr double kPriorFreedom = 6.0;

double ballVolume(double radius_m) { return 4.0 / 3.0 * std::numbers::pi * std::pow(radius_m, 3); }

/// Where a fourth point stands over the plane of three.
struct Height {
  double height_m = 0.0;
  double lever = 0.0;  ///< how many times larger its error may be than that of a distance

  Height(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d) {
    const Vector3d ab = b - a, ac = c - a, ad = d - a;
    const Vector3d normal = ab.cross(ac);
    const double twice_area = normal.norm();
    height_m = normal.dot(ad) / twice_area;
    lever = 1.0 + ad.norm() * (ab.norm() + ac.norm()) / twice_area;
  }
};

void forget(Constellation& fit, std::size_t markers) {
  fit.X_CT = RigidTransform::Identity();
  fit.point_of_marker.assign(markers, -1);
  fit.matched = 0;
  fit.rms_m = fit.misfit = fit.evidence = 0.0;
  fit.chance = 1.0;
}

}  // namespace

void forget(SearchResult& result, std::size_t markers) {
  result.verdict = SearchVerdict::kTooFewMarkers;
  forget(result.best, markers);
  forget(result.runner_up, markers);
}

void TargetSearch::run(const Sought& sought, SearchResult& result) {
  sought_ = sought;
  result_ = &result;
  forget(result, sought.markers_T.size());
  free_points_ = static_cast<int>(std::ranges::count_if(sought.free, [](char free) { return free != 0; }));
  least_ = std::min(kLeastMarkers, static_cast<int>(sought.markers_T.size()));
  if (free_points_ < least_ || areCollinear(sought.markers_T)) return;
  steps_ = settings_.max_steps;
  gate_ = {sought.tolerance_m, settings_.sigmas};
  const double allowed_m = settings_.sigmas * sought.cloud->typicalSigma();
  gate_m_ = sought.tolerance_m + allowed_m;
  width_m_ = sought.tolerance_m + std::numbers::sqrt2 * allowed_m;
  buildGraph();
  fit_.begin(sought.markers_T, *sought.cloud, sought.free, gate_);
  seekBest();
  if (result.best.matched == 0) {
    if (steps_ <= 0) result.verdict = SearchVerdict::kCutOff;
    return;
  }
  weigh();
  seekRunnerUp();
  result.verdict = verdict();
}

void TargetSearch::buildGraph() {
  graph_.reset(static_cast<int>(sought_.markers_T.size()), sought_.cloud->size());
  agreements_ = 0;
  for (const auto& [a, b, k, l] : sought_.agreements) {
    if (sought_.free[k] == 0 || sought_.free[l] == 0) continue;
    ++agreements_;
    graph_.join({a, k}, {b, l});
    graph_.join({a, l}, {b, k});
  }
}

void TargetSearch::seekBest() {
  seeks_runner_up_ = false;
  (void)cliques_.run(graph_, least_, {}, *this, steps_);
}

void TargetSearch::seekRunnerUp() {
  seeks_runner_up_ = true;
  markExplained();
  (void)cliques_.run(graph_, std::max(least_, result_->best.matched - 1), explained_, *this, steps_);
}

bool TargetSearch::mayJoin(std::span<const Pairing, 3> three, Pairing next) {
  const auto& cloud = *sought_.cloud;
  const Height model(marker(three[0].marker), marker(three[1].marker), marker(three[2].marker),
                     marker(next.marker));
  const Height seen(cloud.at(three[0].point), cloud.at(three[1].point), cloud.at(three[2].point),
                    cloud.at(next.point));
  const bool is_mirrored = model.height_m * seen.height_m < 0.0;
  return !is_mirrored || !(std::abs(model.height_m - seen.height_m) > 2.0 * model.lever * width_m_);
}

int TargetSearch::judge(std::span<const Pairing> clique) {
  steps_ -= kStepsOfAFit + graph_.markers() * graph_.points() / kPairingsOfAStep;
  return seeks_runner_up_ ? judgeRunnerUp(clique) : judgeBest(clique);
}

int TargetSearch::judgeBest(std::span<const Pairing> clique) {
  const int least = std::max(least_, result_->best.matched + 1);
  if (!fit_.run(clique, least, trial_)) return least;
  std::swap(trial_, result_->best);
  return result_->best.matched + 1;
}

/// One fewer marker than the best may do, but once as many are found, fewer do not matter.
int TargetSearch::judgeRunnerUp(std::span<const Pairing> clique) {
  Constellation &best = result_->best, &runner_up = result_->runner_up;
  const int least = std::max({least_, best.matched - 1, runner_up.matched});
  if (!fit_.run(clique, least, trial_) || isSamePose(trial_)) return least;
  weigh(trial_);
  if (runner_up.matched > 0 && trial_.evidence <= runner_up.evidence) return least;
  std::swap(trial_, runner_up);
  if (runner_up.evidence > best.evidence) {
    std::swap(runner_up, best);
    weigh();
    weigh(runner_up);
  }
  const int wanted = std::max(least_, std::min(best.matched, runner_up.matched + 1));
  // Nothing that is still to come could make it clear again.
  return areOddsClear() ? wanted : static_cast<int>(sought_.markers_T.size()) + 1;
}

void TargetSearch::markExplained() {
  const auto& cloud = *sought_.cloud;
  explained_.assign(sought_.markers_T.size(), {});
  for (std::size_t i = 0; i < explained_.size(); ++i) {
    const Vector3d expected_C = result_->best.X_CT * sought_.markers_T[i];
    for (int point = 0; point < cloud.size(); ++point) {
      const Vector3d off_m = cloud.at(point) - expected_C;
      if (gate_.mayReach(cloud, point, off_m, kGatesOfAPose) &&
          gate_.share(cloud, point, off_m) <= kGatesOfAPose)
        explained_[i] |= PointSet::of(point);
    }
  }
}

/// Whether the best pose puts the other's markers where the other does.
bool TargetSearch::isSamePose(const Constellation& other) const {
  for (std::size_t i = 0; i < other.point_of_marker.size(); ++i) {
    if (other.point_of_marker[i] < 0) continue;
    const Vector3d& marker_T = sought_.markers_T[i];
    if ((result_->best.X_CT * marker_T - other.X_CT * marker_T).norm() > kGatesOfAPose * gate_m_)
      return false;
  }
  return true;
}

/// What the best fit is worth, and any other fit beside it.
void TargetSearch::weigh() {
  Constellation& best = result_->best;
  const double density = densityAround(best.X_CT);
  crowd_ = {static_cast<int>(sought_.markers_T.size()), free_points_, pairRate(),
            density * ballVolume(kSweptWidths * width_m_)};
  const double variance = std::pow(sought_.cloud->typicalSigma(), 2) + gate_.modelVariance();
  gain_ = std::max(0.0, -std::log(density * std::pow(2.0 * std::numbers::pi * variance, 1.5)));
  const double sensor_share = std::pow(sought_.cloud->typicalSigma(), 2) / variance;
  misfit_scale_ =
      std::max(sensor_share, (best.misfit + kPriorFreedom) / (3.0 * best.matched - 6.0 + kPriorFreedom));
  weigh(best);
}

void TargetSearch::weigh(Constellation& fit) const {
  fit.chance = expectedChanceFits(crowd_, fit.matched);
  fit.evidence = fit.matched * gain_ - 0.5 * fit.misfit / misfit_scale_;
}

/// As measured on this cloud without the best fit's own pairs, but not less than in a cloud spread evenly: a
/// small cloud has too few pairs to tell.
double TargetSearch::pairRate() const {
  const auto pairs = [](double count) { return 0.5 * count * (count - 1.0); };
  const auto markers = static_cast<int>(sought_.markers_T.size());
  const double own = pairs(result_->best.matched);
  const double others = pairs(markers) * pairs(free_points_) - own;
  const double measured = others > 0.0 ? std::max(0.0, (agreements_ - own) / others) : 0.0;
  double even = 0.0;
  for (int i = 0; i < markers; ++i)
    for (int j = 0; j < i; ++j)
      even +=
          pairRateInBall((marker(i) - marker(j)).norm(), width_m_, sought_.cloud->radius()) / pairs(markers);
  return std::max(measured, even);
}

/// Free points for each cubic metre within the target's reach, three for the pose not counted; one at least.
double TargetSearch::densityAround(const RigidTransform& X_CT) const {
  Vector3d middle_T = Vector3d::Zero();
  for (const Vector3d& each : sought_.markers_T)
    middle_T += each / static_cast<double>(sought_.markers_T.size());
  double reach_m = 0.0;
  for (const Vector3d& each : sought_.markers_T) reach_m = std::max(reach_m, (each - middle_T).norm());
  const Vector3d middle_C = X_CT * middle_T;
  int near = 0;
  for (int point = 0; point < sought_.cloud->size(); ++point)
    near += static_cast<int>(sought_.free[static_cast<std::size_t>(point)] != 0 &&
                             (sought_.cloud->at(point) - middle_C).norm() <= reach_m + gate_m_);
  return std::max(1, near - 3) / ballVolume(reach_m + gate_m_);
}

bool TargetSearch::areOddsClear() const {
  return result_->best.evidence - result_->runner_up.evidence >= -std::log(settings_.max_chance);
}

SearchVerdict TargetSearch::verdict() const {
  if (steps_ <= 0) return SearchVerdict::kCutOff;
  const bool is_crowd = result_->best.matched < kLeastMarkers && free_points_ > kMostPointsForThree;
  if (is_crowd || result_->best.chance > settings_.max_chance) return SearchVerdict::kTooFewMarkers;
  if (result_->runner_up.matched > 0 && !areOddsClear()) return SearchVerdict::kAmbiguous;
  return SearchVerdict::kFound;
}

}  // namespace mirrorarm::tracking
