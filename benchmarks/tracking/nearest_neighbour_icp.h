#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/geometry/rigid_transform.h"

namespace mirrorarm::benchmarks::tracking {

/// The plain reference: every model point takes its nearest cloud point, Kabsch's pose over the nearest 80 %
/// of the pairs (all points may not be seen), again until the pairs stay. Source: Besl, McKay, T-PAMI 14(2),
/// 1992; trimmed as in Chetverikov, Stepanov, Krsek, Image and Vision Computing 23(3), 2005.
struct IcpResult {
  RigidTransform X_YX = RigidTransform::Identity();
  std::vector<int> y_of_x;  ///< pairs nearer than the gate, -1 for none
};
[[nodiscard]] IcpResult nearestNeighbourIcp(std::span<const Eigen::Vector3d> x,
                                            std::span<const Eigen::Vector3d> y, double gate_m);

}  // namespace mirrorarm::benchmarks::tracking
