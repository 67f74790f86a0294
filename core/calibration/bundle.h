#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/calibration/sighting.h"
#include "core/camera/camera_model.h"
#include "core/geometry/rigid_transform.h"

namespace mirrorarm::calibration {

/// Everything that a calibration solves for at once: one camera, or two on a bar.
struct Bundle {
  std::vector<camera::Intrinsics> cameras;
  RigidTransform X_RC = RigidTransform::Identity();  ///< second camera from first; unused for one camera
  std::vector<RigidTransform> X_CM;                  ///< board in the first camera, a view each

  /// Board of view `v` in camera `k`.
  [[nodiscard]] RigidTransform boardIn(std::size_t k, std::size_t v) const {
    return k == 0 ? X_CM[v] : X_RC * X_CM[v];
  }
};

struct AdjustSettings {
  /// Misfit of a point, in its standard deviations, beyond which it pulls no harder (Huber); 0: least
  /// squares.
  double huber = 0.0;
  int most_steps = 100;
};

struct AdjustedBundle {
  Bundle bundle;
  double squares = 0.0;  ///< what was made least, in squared standard deviations
};

/// Refines all numbers of `start` together so that the projected points meet the seen ones: Levenberg and
/// Marquardt by Ceres, the views' poses eliminated (Schur). Free are the LensNumbers of each camera, the bar
/// and the poses. Every image of every view shows at least 4 points; a point counts by its sigma_px, where
/// that is 0 by 1 px. Nothing when a point cannot be projected at the start, or when no step helps. Source:
/// Triggs et al., Bundle Adjustment - A Modern Synthesis, 1999, sections 3, 4 and 6.
[[nodiscard]] std::optional<AdjustedBundle> adjustBundle(const Bundle& start,
                                                         std::span<const Eigen::Vector3d> board,
                                                         std::span<const BoardView> views,
                                                         const AdjustSettings& settings = {});

}  // namespace mirrorarm::calibration
