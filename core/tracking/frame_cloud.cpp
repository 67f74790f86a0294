#include "core/tracking/frame_cloud.h"

#include <algorithm>
#include <limits>

namespace mirrorarm::tracking {
namespace {

// Answers name points by 16 bits.
constexpr auto kMost = static_cast<std::size_t>(std::numeric_limits<std::int16_t>::max()) + 1;

}  // namespace

void FrameCloud::reset(std::span<const vision::StereoPoint> points) {
  points_.clear();
  source_.clear();
  has_rivals_.clear();
  for (std::size_t i = 0; i < std::min(points.size(), kMost); ++i) {
    if (!points[i].p_C.allFinite() || !points[i].covariance_m2.allFinite()) continue;
    points_.push_back(cloudPointOf(points[i]));
    source_.push_back(static_cast<int>(i));
    has_rivals_.push_back(points[i].rivals > 0 ? 1 : 0);
  }
  taken_.assign(points_.size(), 0);
  clearSelection();
}

int FrameCloud::countFree() const { return static_cast<int>(std::count(taken_.begin(), taken_.end(), 0)); }

void FrameCloud::take(int point) {
  const auto taken = static_cast<std::size_t>(point);
  taken_[taken] = 1;
  if (has_rivals_[taken] == 0) return;
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (shareADisc(points_[i].discs, points_[taken].discs)) taken_[i] = 1;
}

void FrameCloud::clearSelection() {
  selection_.clear();
  selected_.clear();
}

void FrameCloud::select(std::size_t point) {
  selection_.push_back(points_[point]);
  selected_.push_back(static_cast<int>(point));
}

std::span<const CloudPoint> FrameCloud::selectNear(std::span<const Eigen::Vector3d> places_C,
                                                   double radius_m) {
  clearSelection();
  for (std::size_t i = 0; i < points_.size() && selection_.size() < kMaxPoints; ++i) {
    const bool near = taken_[i] == 0 && std::any_of(places_C.begin(), places_C.end(), [&](const auto& place) {
                        return (place - points_[i].p_C).squaredNorm() <= radius_m * radius_m;
                      });
    if (near) select(i);
  }
  return selection_;
}

std::span<const CloudPoint> FrameCloud::selectFree() {
  clearSelection();
  for (std::size_t i = 0; i < points_.size() && selection_.size() < kMaxPoints; ++i)
    if (taken_[i] == 0) select(i);
  return selection_;
}

}  // namespace mirrorarm::tracking
