#pragma once

#include <Eigen/Core>

namespace mirrorarm::robot {

/// The straight line between two points, which may be one.
struct Segment {
  Eigen::Vector3d a = Eigen::Vector3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
};

/// The nearest points of two bodies and the distance between them; of bodies that overlap the distance is
/// negative or zero.
struct Nearest {
  Eigen::Vector3d on_first = Eigen::Vector3d::Zero();
  Eigen::Vector3d on_second = Eigen::Vector3d::Zero();
  double distance_m = 0.0;
};

/// Exact, also for parallel segments and points. Source: Ericson, Real-Time Collision Detection,
/// section 5.1.9.
[[nodiscard]] Nearest nearest(const Segment& one, const Segment& other);

/// A segment and a box around the origin along the axes, both in the box's frame; `half_size` may be zero in
/// any direction. Exact outside. Where the segment goes through the box: a point of it inside, the nearest
/// point of the surface and the depth, negative.
[[nodiscard]] Nearest nearestToBox(const Segment& segment, const Eigen::Vector3d& half_size);

}  // namespace mirrorarm::robot
