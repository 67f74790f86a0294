#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/geometry/rigid_transform.h"
#include "core/tracking/deviation_modes.h"
#include "core/tracking/shape_gauge.h"

namespace mirrorarm::tracking {

/// The frame that the stiffest part of the skin carries. Deviations are told from the mean frame of all
/// markers, in which a twist of one end turns the other end back. To each mode belongs a rigid motion that,
/// put upon it, leaves as many markers still as can be: least sum of log(square + floor), by reweighted least
/// squares, so each marker's weight is the inverse of how far the mode carries it. Source: Candes, Wakin,
/// Boyd, Enhancing sparsity by reweighted l1 minimization, J. Fourier Anal. Appl. 14, 2008.
class StiffFrame {
 public:
  /// Follows the modes after they were learnt; a few steps a frame.
  void learn(const DeviationModes& modes, std::span<const Eigen::Vector3d> rest_T,
             std::span<const char> present);
  /// From the mean frame to the frame of the stiff part, with these amplitudes of the modes [m].
  [[nodiscard]] RigidTransform motion(const ModeVector& amplitudes) const;

 private:
  void step(int mode, const DeviationModes& modes, std::span<const char> present);

  Eigen::Matrix<double, 6, kModes> motions_ = Eigen::Matrix<double, 6, kModes>::Zero();
  std::vector<RigidRows> rows_;
};

}  // namespace mirrorarm::tracking
