#pragma once

#include <optional>

#include "core/camera/stereo_rig.h"
#include "core/vision/detected_marker.h"
#include "core/vision/matcher_settings.h"
#include "core/vision/stereo_observation.h"

namespace mirrorarm::vision {

/// What two markers say together about the one disc that they may be.
struct PairMeasurement {
  /// All but its indices, epipolar distance, support and rivals.
  StereoPoint point;
  double shape_misfit = 0.0;  ///< chi squared, 3 degrees of freedom; 0 where a cut outline cannot be judged
};

/// The disc near `start_C`, within a few pixels of both centres: its normal from both outlines, its centres
/// corrected with that, triangulated; how uncertain the normal leaves the correction is part of the
/// covariance. Nothing when no disc has both outlines, or a lens model does not hold.
[[nodiscard]] std::optional<PairMeasurement> measurePair(const camera::StereoRig& rig,
                                                         const MatcherSettings& settings,
                                                         const Eigen::Vector3d& start_C,
                                                         const DetectedMarker& left,
                                                         const DetectedMarker& right);

}  // namespace mirrorarm::vision
