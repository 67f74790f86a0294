#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "core/geometry/rigid_transform.h"

namespace mirrorarm::tracking {

/// The paper's parameters (section 3.1). beta is in 1/mm^2, as the paper's figures imply.
struct SoftassignSettings {
  double beta_start = 1e-4;
  double beta_factor = 1.053;
  double beta_max = 1e3;
  int max_mutual_updates = 10;      ///< correspondence <-> pose at one beta
  double tolerated_distance_m = 0.003;  ///< alpha is its square: pairs nearer than this attract
};

struct SoftassignResult {
  RigidTransform X_YX = RigidTransform::Identity();  ///< moves the model onto the cloud
  std::vector<int> y_of_x;  ///< for each model point its cloud point, -1 for none
  int matched = 0;
  double rms_m = 0.0;       ///< over the matched pairs
};

/// Registers the model points `x` to the measured cloud `y`: softmax correspondences with slack row and column,
/// normalised in turn, annealed by beta, and the pose by dual quaternions. Computed in the log domain: exp() of
/// equation 23 overflows at the paper's own beta_max.
/// `start` is the first guess; without it the clouds' centroids are laid on each other without turning.
/// Either cloud may hold points without partner. Empty clouds give no match.
/// Source: paper sections 2.3.1 to 2.3.5; Gold et al., Pattern Recognition 31(8), 1998.
[[nodiscard]] SoftassignResult registerSoftassign(std::span<const Eigen::Vector3d> x,
                                                  std::span<const Eigen::Vector3d> y,
                                                  const SoftassignSettings& settings,
                                                  const std::optional<RigidTransform>& start = std::nullopt);

}  // namespace mirrorarm::tracking
