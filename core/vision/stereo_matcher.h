#pragma once

#include <span>
#include <vector>

#include "core/camera/stereo_rig.h"
#include "core/vision/stereo_observation.h"

namespace mirrorarm::vision {

struct MatcherSettings {
  double epipolar_tolerance_px =
      1.5;  ///< distance from the epipolar line, rectified at the rig's own focal length
  double max_disparity_gradient = 1.0;  ///< |Gamma| that still supports a pair (paper: 1)
  double min_depth_m = 0.10;
  double max_depth_m = 2.0;
};

/// Pairs left and right markers and triangulates them. Every pair near its epipolar line is a candidate; each
/// is scored by the other candidates whose disparity gradient with it is within the limit, weighted by
/// reciprocal distance in the cyclopean image; the best score is taken first and closes both its markers.
/// Source: paper section 2.2.2, equations 10 and 11; Pollard, Mayhew, Frisby, Perception 14, 1985.
[[nodiscard]] std::vector<StereoPoint> matchStereo(const camera::StereoRig& rig,
                                                   std::span<const DetectedMarker> left,
                                                   std::span<const DetectedMarker> right,
                                                   const MatcherSettings& settings);

}  // namespace mirrorarm::vision
