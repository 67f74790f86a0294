#pragma once

#include <limits>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/geometry/rigid_transform.h"

namespace mirrorarm::tracking {

/// What makes markers of two shapes lie alike.
struct Likeness {
  double distance_tolerance_m = 0.001;  ///< of each distance between two of them
  double max_rms_m = 0.001;             ///< of the rigid fit: tells mirror images
  int least_markers = 3;
};

/// The most markers of shape X that lie like markers of shape Y.
struct SharedShape {
  RigidTransform X_YX = RigidTransform::Identity();
  std::vector<int> y_of_x;  ///< a marker of Y for each of X, -1 for none
  int markers = 0;          ///< 0 when fewer than the least lie alike
  double rms_m = std::numeric_limits<double>::infinity();
};

/// Of several as large the one that fits best. Bounded work: of shapes full of alike distances the largest
/// one that was met.
[[nodiscard]] SharedShape findSharedShape(std::span<const Eigen::Vector3d> x,
                                          std::span<const Eigen::Vector3d> y, const Likeness& likeness);

/// How a shape lies on itself in another pose than its own: one that takes some marker farther than
/// `apart_m` from its place.
[[nodiscard]] SharedShape findSelfLikeness(std::span<const Eigen::Vector3d> x, const Likeness& likeness,
                                           double apart_m);

}  // namespace mirrorarm::tracking
