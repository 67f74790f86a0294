#pragma once

namespace mirrorarm::vision {

/// What the matcher takes for two images of one disc.
struct MatcherSettings {
  double epipolar_gate_sigmas = 4.0;  ///< of the distance from the epipolar line
  /// What the calibration adds to that distance where the rig's record does not tell [px], and at least.
  double unknown_calibration_px = 0.35;
  double least_calibration_px = 0.05;
  double max_shape_misfit = 40.0;       ///< chi squared (3 degrees of freedom) of two outlines as one disc
  double max_disparity_gradient = 1.0;  ///< |Gamma| that still supports a pair (paper: 1)
  double min_depth_m = 0.10;
  double max_depth_m = 2.0;
  /// Frees the centres of eccentricity and lens curvature: for methods that fit the raw image.
  bool correct_centres = true;
};

}  // namespace mirrorarm::vision
