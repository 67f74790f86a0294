#include "core/tracking/running_model.h"

#include <algorithm>

#include "core/tracking/tracked_target.h"

namespace mirrorarm::tracking {
namespace {

constexpr std::size_t kMaxCandidates = 256;

bool isBetterSeen(const RunningModel::Point& a, const RunningModel::Point& b) { return a.seen > b.seen; }

}  // namespace

void RunningModel::add(std::span<const Eigen::Vector3d> cloud_C, const RigidTransform& X_CT, double gate_m) {
  const RigidTransform X_TC = X_CT.inverse();
  cloud_T_.clear();
  for (const auto& p_C : cloud_C) cloud_T_.push_back(X_TC * p_C);
  means_T_.clear();
  for (const auto& point : points_) means_T_.push_back(point.mean_T);
  association_.pair(means_T_, cloud_T_, RigidTransform::Identity(), gate_m, cloud_of_point_);

  std::vector<char> is_new(cloud_T_.size(), 1);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (cloud_of_point_[i] < 0) continue;
    const auto k = static_cast<std::size_t>(cloud_of_point_[i]);
    update(points_[i], cloud_T_[k]);
    is_new[k] = 0;
  }
  for (std::size_t k = 0; k < cloud_T_.size(); ++k)
    if (is_new[k] != 0) points_.push_back({cloud_T_[k], Eigen::Matrix3d::Zero(), 1});
  ++frames_;
  forgetRarest();
}

// Welford's running mean and scatter.
void RunningModel::update(Point& point, const Eigen::Vector3d& p_T) const {
  ++point.seen;
  const Eigen::Vector3d before = p_T - point.mean_T;
  point.mean_T += before / point.seen;
  point.scatter_m2 += before * (p_T - point.mean_T).transpose();
}

void RunningModel::forgetRarest() {
  if (points_.size() <= kMaxCandidates) return;
  std::stable_sort(points_.begin(), points_.end(), isBetterSeen);
  // Room for what the next clouds bring.
  points_.resize(kMaxCandidates / 2);
}

std::vector<RunningModel::Point> RunningModel::markers(double presence, double distance_m) const {
  std::vector<Point> by_presence = points_;
  std::stable_sort(by_presence.begin(), by_presence.end(), isBetterSeen);
  std::vector<Point> kept;
  for (const auto& point : by_presence) {
    const bool doubled = std::any_of(kept.begin(), kept.end(), [&](const Point& other) {
      return (other.mean_T - point.mean_T).norm() < distance_m;
    });
    if (doubled || point.seen < presence * frames_ || kept.size() == static_cast<std::size_t>(kMaxMarkers))
      continue;
    kept.push_back(point);
  }
  return kept;
}

int RunningModel::steadyCount() const {
  return static_cast<int>(std::count_if(points_.begin(), points_.end(),
                                        [this](const Point& point) { return 2 * point.seen > frames_; }));
}

}  // namespace mirrorarm::tracking
