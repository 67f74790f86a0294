#include "core/tracking/running_model.h"

#include <algorithm>
#include <cmath>

#include "core/tracking/tracked_target.h"

namespace mirrorarm::tracking {
namespace {

constexpr std::size_t kMaxCandidates = 256;
constexpr int kProvenBy = 3;         // sightings
constexpr int kScatterKnownBy = 10;  // likewise
constexpr double kGateInScatter = 6.0;
constexpr double kLeastGate_m = 0.0005;
constexpr double kSteadyPresence = 0.5;
constexpr double kRivalShare = 0.2;  // of the sightings
constexpr std::size_t kMaxRivals = 32;
// A body that moved by so much tells what does not move with it.
constexpr double kTellingTravel_m = 0.003;
constexpr double kLeastShareOfTravel = 0.02;  // of variances
constexpr double kFewestSeenOnTheWay = 20;
constexpr double kLeastPresenceOnTheWay = 0.1;
constexpr double kShareOfTravelOnTheWay = 0.25;

bool isBetterSeen(const RunningModel::Point& a, const RunningModel::Point& b) {
  if (a.seen != b.seen) return a.seen > b.seen;
  return a.scatter_m2.trace() < b.scatter_m2.trace();
}

/// A few common discs tell nothing: a ghost may once have been taken for a hidden marker.
bool areRivals(const RunningModel::Point& a, const RunningModel::Point& b) {
  return std::any_of(a.rivals.begin(), a.rivals.end(), [&](const RunningModel::Rival& rival) {
    return rival.id == b.id && rival.times > kRivalShare * std::min(a.seen, b.seen);
  });
}

void countRival(RunningModel::Point& point, int id) {
  const auto known = std::find_if(point.rivals.begin(), point.rivals.end(),
                                  [id](const RunningModel::Rival& rival) { return rival.id == id; });
  if (known != point.rivals.end()) {
    ++known->times;
  } else if (point.rivals.size() < kMaxRivals) {
    point.rivals.push_back({id, 1});
  }
}

/// How far from its mean a point may lie.
double ownGate(const RunningModel::Point& point, double gate_m) {
  if (point.seen < kScatterKnownBy) return gate_m;
  const double sigma_m = std::sqrt(point.scatter_m2.trace() / (3.0 * point.seen));
  return std::clamp(kGateInScatter * sigma_m, std::min(kLeastGate_m, gate_m), gate_m);
}

}  // namespace

void RunningModel::clear() {
  points_.clear();
  frames_ = 0;
}

std::span<const Sighting> RunningModel::add(std::span<const CloudPoint> cloud, const RigidTransform& X_CT,
                                            double gate_m) {
  const RigidTransform X_TC = X_CT.inverse();
  cloud_T_.clear();
  for (const auto& point : cloud) cloud_T_.push_back(X_TC * point.p_C);
  means_T_.clear();
  for (const auto& point : points_) means_T_.push_back(point.mean_T);
  association_.pair(means_T_, cloud_T_, RigidTransform::Identity(), gate_m, cloud_of_point_);

  point_of_cloud_.assign(cloud.size(), -1);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (cloud_of_point_[i] < 0) continue;
    const auto k = static_cast<std::size_t>(cloud_of_point_[i]);
    if ((cloud_T_[k] - points_[i].mean_T).norm() > ownGate(points_[i], gate_m)) continue;
    update(points_[i], cloud[k], cloud_T_[k]);
    point_of_cloud_[k] = static_cast<int>(i);
  }
  sightings_.clear();
  for (std::size_t k = 0; k < cloud.size(); ++k) {
    if (point_of_cloud_[k] < 0) {
      point_of_cloud_[k] = static_cast<int>(points_.size());
      append(cloud[k], cloud_T_[k]);
    }
    const auto& point = points_[static_cast<std::size_t>(point_of_cloud_[k])];
    sightings_.push_back({point.id, cloud[k].p_C, cloud[k].covariance_m2});
  }
  noteRivals(cloud);
  ++frames_;
  forgetRarest();
  return sightings_;
}

// Welford's running mean and scatter.
void RunningModel::update(Point& point, const CloudPoint& seen, const Eigen::Vector3d& p_T) const {
  ++point.seen;
  const Eigen::Vector3d before = p_T - point.mean_T;
  point.mean_T += before / point.seen;
  point.scatter_m2 += before * (p_T - point.mean_T).transpose();
  const Eigen::Vector3d before_C = seen.p_C - point.mean_C;
  point.mean_C += before_C / point.seen;
  point.travel_m2 += before_C.dot(seen.p_C - point.mean_C);
}

void RunningModel::append(const CloudPoint& seen, const Eigen::Vector3d& p_T) {
  Point point;
  point.id = next_id_++;
  point.first_frame = frames_;
  point.seen = 1;
  point.mean_T = p_T;
  point.mean_C = seen.p_C;
  points_.push_back(point);
}

void RunningModel::noteRivals(std::span<const CloudPoint> cloud) {
  for (std::size_t k = 0; k < cloud.size(); ++k)
    for (std::size_t l = 0; l < k; ++l) {
      if (!shareADisc(cloud[k].discs, cloud[l].discs)) continue;
      auto& a = points_[static_cast<std::size_t>(point_of_cloud_[k])];
      auto& b = points_[static_cast<std::size_t>(point_of_cloud_[l])];
      countRival(a, b.id);
      countRival(b, a.id);
    }
}

void RunningModel::correct(int id, const Eigen::Vector3d& mean_T, double spread_m) {
  const auto found =
      std::find_if(points_.begin(), points_.end(), [id](const Point& point) { return point.id == id; });
  if (found == points_.end()) return;
  found->mean_T = mean_T;
  found->spread_m = spread_m;
}

void RunningModel::forgetRarest() {
  if (points_.size() <= kMaxCandidates) return;
  std::stable_sort(points_.begin(), points_.end(), isBetterSeen);
  // Room for what the next clouds bring.
  points_.resize(kMaxCandidates / 2);
}

std::vector<RunningModel::Point> RunningModel::steadyPoints() const {
  std::vector<Point> steady;
  for (const auto& point : points_)
    if (point.seen >= std::min(kProvenBy, frames_) &&
        point.seen >= kSteadyPresence * (frames_ - point.first_frame))
      steady.push_back(point);
  std::stable_sort(steady.begin(), steady.end(), isBetterSeen);
  if (steady.size() > static_cast<std::size_t>(kMaxMarkers)) steady.resize(kMaxMarkers);
  return steady;
}

std::vector<RunningModel::Point> RunningModel::markers(double presence, double distance_m) const {
  const double travel_m2 = travelOfBody();
  std::vector<Point> by_presence = points_;
  std::stable_sort(by_presence.begin(), by_presence.end(), isBetterSeen);
  std::vector<Point> kept;
  for (const auto& point : by_presence) {
    const bool doubled = std::any_of(kept.begin(), kept.end(), [&](const Point& other) {
      return (other.mean_T - point.mean_T).norm() < distance_m || areRivals(other, point);
    });
    if (doubled || !movesWithBody(point, presence, travel_m2) ||
        kept.size() == static_cast<std::size_t>(kMaxMarkers))
      continue;
    kept.push_back(point);
  }
  std::sort(kept.begin(), kept.end(), [](const Point& a, const Point& b) { return a.id < b.id; });
  return kept;
}

/// Mean square of the way that the well-seen points went before the camera: of the median one.
double RunningModel::travelOfBody() const {
  std::vector<double> travels_m2;
  for (const auto& point : points_)
    if (point.seen >= kSteadyPresence * frames_) travels_m2.push_back(point.travel_m2 / point.seen);
  if (travels_m2.empty()) return 0.0;
  const auto middle = travels_m2.begin() + static_cast<std::ptrdiff_t>(travels_m2.size() / 2);
  std::nth_element(travels_m2.begin(), middle, travels_m2.end());
  return *middle;
}

bool RunningModel::movesWithBody(const Point& point, double presence, double travel_m2) const {
  const double own_m2 = point.travel_m2 / point.seen;
  const bool telling = travel_m2 > kTellingTravel_m * kTellingTravel_m;
  if (telling && (own_m2 < kLeastShareOfTravel * travel_m2 || point.scatter_m2.trace() > point.travel_m2))
    return false;
  if (point.seen >= presence * frames_) return true;
  return telling && point.seen >= kFewestSeenOnTheWay && point.seen >= kLeastPresenceOnTheWay * frames_ &&
         own_m2 > kShareOfTravelOnTheWay * travel_m2;
}

}  // namespace mirrorarm::tracking
