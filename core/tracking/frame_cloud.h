#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/tracking/cloud_point.h"
#include "core/tracking/tracked_target.h"
#include "core/vision/stereo_observation.h"

namespace mirrorarm::tracking {

/// The points of one frame: which of them are some target's already, and the few that one target looks at.
/// Keeps its buffers; one thread.
class FrameCloud {
 public:
  /// Takes over the finite ones of the first 32768 points; all are free.
  void reset(std::span<const vision::StereoPoint> points);

  [[nodiscard]] std::span<const CloudPoint> points() const { return points_; }
  /// A flag for each point: some target's, or measured from a disc of one that is.
  [[nodiscard]] std::span<const char> taken() const { return taken_; }
  [[nodiscard]] int countFree() const;
  /// The place of a point among those given to reset().
  [[nodiscard]] int sourceOf(int point) const { return source_[static_cast<std::size_t>(point)]; }
  void take(int point);

  /// The free points within `radius_m` of one of `places_C`, at most kMaxPoints, in their order.
  std::span<const CloudPoint> selectNear(std::span<const Eigen::Vector3d> places_C, double radius_m);
  /// The free points, at most kMaxPoints, in their order.
  std::span<const CloudPoint> selectFree();
  /// Which of points() the last selected ones are.
  [[nodiscard]] int pointOf(int selected) const { return selected_[static_cast<std::size_t>(selected)]; }

 private:
  void clearSelection();
  void select(std::size_t point);

  std::vector<CloudPoint> points_;
  std::vector<int> source_;
  std::vector<char> taken_;
  std::vector<char> has_rivals_;
  std::vector<CloudPoint> selection_;
  std::vector<int> selected_;
};

}  // namespace mirrorarm::tracking
