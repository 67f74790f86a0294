#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/common/time.h"
#include "core/vision/detected_marker.h"

namespace mirrorarm::vision {

/// A disc seen by both cameras.
struct StereoPoint {
  Eigen::Vector3d p_C = Eigen::Vector3d::Zero();  ///< centre in the left camera [m]
  Eigen::Matrix3d covariance_m2 = Eigen::Matrix3d::Zero();
  int left = -1;             ///< index into the left image's markers
  int right = -1;            ///< index into the right image's markers
  double epipolar_px = 0.0;  ///< distance of the right centre from the left one's epipolar line
};

/// Everything that vision says about one frame.
struct StereoObservation {
  Detection left;
  Detection right;
  std::vector<StereoPoint> points;
  TimePoint exposed_at{};
  std::uint64_t sequence = 0;
};

}  // namespace mirrorarm::vision
