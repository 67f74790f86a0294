#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/geometry/rigid_transform.h"
#include "core/tracking/association.h"

namespace mirrorarm::tracking {

/// The model while it is taught: for every point ever seen on the body its running mean, scatter and how
/// often it was seen. Strangers are in it too, until they are seen too seldom. One thread.
class RunningModel {
 public:
  struct Point {
    Eigen::Vector3d mean_T = Eigen::Vector3d::Zero();
    Eigen::Matrix3d scatter_m2 = Eigen::Matrix3d::Zero();  ///< sum of the squared deviations from the mean
    int seen = 0;
  };

  /// Takes one cloud that lies at X_CT; points within `gate_m` of a known one update it, the others are
  /// added.
  void add(std::span<const Eigen::Vector3d> cloud_C, const RigidTransform& X_CT, double gate_m);

  [[nodiscard]] int frames() const { return frames_; }
  /// Points seen in at least `presence` of the frames, best seen first, at most kMaxMarkers; none that is
  /// nearer than `distance_m` to a better seen one.
  [[nodiscard]] std::vector<Point> markers(double presence, double distance_m) const;
  /// Points seen in more than half of the frames.
  [[nodiscard]] int steadyCount() const;

 private:
  void update(Point& point, const Eigen::Vector3d& p_T) const;
  void forgetRarest();

  std::vector<Point> points_;
  int frames_ = 0;
  Association association_;
  std::vector<Eigen::Vector3d> means_T_, cloud_T_;
  std::vector<int> cloud_of_point_;
};

}  // namespace mirrorarm::tracking
