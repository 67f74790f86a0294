#pragma once

#include <optional>
#include <string>

#include "core/calibration/hold_out.h"
#include "core/camera/stereo_rig.h"

namespace mirrorarm::calibration {

/// How one view agrees with the lens or the rig.
struct ViewResidual {
  std::string name;
  double rms_px = 0.0;      ///< over its images, the board posed from this view alone, outlier points aside
  bool is_outlier = false;  ///< left out of the solution
  bool is_held_out = false;
  int outlier_points = 0;           ///< of its points, farther off than the noise explains
  std::optional<HoldOut> hold_out;  ///< of this view, by a rig not solved from it
};

using camera::LensSigma;

/// What the views say about the board itself. Its size cannot be seen by cameras: a board larger than said,
/// farther away, looks the same, and the rig's bar comes out shorter by the same share. The hand-eye
/// solution, where the robot's metric comes in, tells that.
struct BoardShape {
  double flatness_rms_m = 0.0;    ///< of the points from their common plane
  double flatness_sigma_m = 0.0;  ///< what noise alone would give
  /// Step along the rows against step from row to row, minus 1 [%]: a print stretched one way.
  double stretch_percent = 0.0;
  double stretch_sigma_percent = 0.0;
  bool is_bent = false;  ///< both by more than noise and more than matters
  bool is_stretched = false;
};

/// One lens model as it was tried.
struct ModelTrial {
  camera::LensModel model = camera::LensModel::kBrownConrady;
  double rms_px = 0.0;
  double hold_out_epipolar_px = 0.0;  ///< of the views behind its solution; 0 for a single camera
  /// Reprojection error on views kept out, of all views that any of the models tried could use: what decides.
  double hold_out_px = 0.0;
};

}  // namespace mirrorarm::calibration
