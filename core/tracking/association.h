#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/geometry/rigid_transform.h"
#include "core/tracking/cloud_point.h"
#include "core/tracking/one_to_one.h"

namespace mirrorarm::tracking {

/// One-to-one pairs of moved model points and cloud points, nearest first. Keeps its buffers.
class Association {
 public:
  /// Fills `y_of_x` (-1 for none) with pairs not farther apart than `gate_m` under `X_YX`, no two of which
  /// share a disc; returns their number. `discs_of_y` may be empty.
  int pair(std::span<const Eigen::Vector3d> x, std::span<const Eigen::Vector3d> y, const RigidTransform& X_YX,
           double gate_m, std::vector<int>& y_of_x, std::span<const SeenDiscs> discs_of_y = {});

 private:
  std::vector<CandidatePair> pairs_;
};

}  // namespace mirrorarm::tracking
