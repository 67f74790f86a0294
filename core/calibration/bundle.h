#pragma once

#include <optional>
#include <span>
#include <string>
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
};

struct BundleFit {
  Bundle bundle;
  double rms_px = 0.0;  ///< distance of a point from its projection, over all points of all images
  std::vector<double> view_rms_px;  ///< the same view by view
  double focal_sigma_share = 0.0;   ///< standard deviation of the worst focal length, as a share of it
};

/// Refines all numbers of `start` together so that the projected points meet the seen ones: least squares by
/// Levenberg and Marquardt, the views' poses eliminated (Schur). Free are fx fy cx cy and k1 k2
/// (brown_conrady, as the paper's model) or k1..k4 (kannala_brandt). Nothing when a point cannot be projected
/// at the start, or when the views do not fix the numbers. Source: Triggs et al., Bundle Adjustment - A
/// Modern Synthesis, 1999, sections 4 and 6.
[[nodiscard]] std::optional<BundleFit> adjustBundle(const Bundle& start,
                                                    std::span<const Eigen::Vector3d> board,
                                                    std::span<const BoardView> views);

}  // namespace mirrorarm::calibration
