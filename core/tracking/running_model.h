#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/geometry/rigid_transform.h"
#include "core/tracking/association.h"
#include "core/tracking/bundle_adjustment.h"
#include "core/tracking/cloud_point.h"

namespace mirrorarm::tracking {

/// The model while it is taught: for every point ever seen near the body its running mean, scatter and how
/// often it was seen. Strangers and ghosts of rival stereo pairs are in it too, until they are seen too
/// seldom or do not move with the body. One thread.
class RunningModel {
 public:
  /// A point that was measured from one of the discs of another.
  struct Rival {
    int id = 0;
    int times = 0;
  };
  struct Point {
    int id = 0;           ///< in the order of their first sightings
    int first_frame = 0;  ///< how many frames there were before it was seen first
    int seen = 0;
    Eigen::Vector3d mean_T = Eigen::Vector3d::Zero();
    Eigen::Matrix3d scatter_m2 = Eigen::Matrix3d::Zero();  ///< sum of the squared deviations from mean_T
    Eigen::Vector3d mean_C = Eigen::Vector3d::Zero();      ///< where it was before the camera
    double travel_m2 = 0.0;                                ///< sum of the squared deviations from mean_C
    double spread_m = -1.0;                                ///< as MarkerNetwork tells it; negative: not known
    std::vector<Rival> rivals;
  };

  void clear();
  /// Takes one cloud that lies at X_CT; points within `gate_m` of a known one, or less once it is known how
  /// little that scatters, update it, the others are added. Returns what was seen of which id, in force
  /// until the next call.
  std::span<const Sighting> add(std::span<const CloudPoint> cloud, const RigidTransform& X_CT, double gate_m);
  /// What an adjustment of the network says of a point.
  void correct(int id, const Eigen::Vector3d& mean_T, double spread_m);

  [[nodiscard]] int frames() const { return frames_; }
  /// Points that the next cloud is likely to show, best seen first, at most kMaxMarkers.
  [[nodiscard]] std::vector<Point> steadyPoints() const;
  /// Points that move with the body: seen in at least `presence` of the frames, or less often but through a
  /// good part of its way; in the order of their ids, at most kMaxMarkers. Of rivals and of points nearer to
  /// each other than `distance_m` the better seen one.
  [[nodiscard]] std::vector<Point> markers(double presence, double distance_m) const;

 private:
  void update(Point& point, const CloudPoint& seen, const Eigen::Vector3d& p_T) const;
  void append(const CloudPoint& seen, const Eigen::Vector3d& p_T);
  void noteRivals(std::span<const CloudPoint> cloud);
  void forgetRarest();
  [[nodiscard]] double travelOfBody() const;
  [[nodiscard]] bool movesWithBody(const Point& point, double presence, double travel_m2) const;

  std::vector<Point> points_;
  int frames_ = 0;
  int next_id_ = 0;
  Association association_;
  std::vector<Eigen::Vector3d> means_T_, cloud_T_;
  std::vector<int> cloud_of_point_, point_of_cloud_;
  std::vector<Sighting> sightings_;
};

}  // namespace mirrorarm::tracking
