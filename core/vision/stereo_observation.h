#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/common/time.h"
#include "core/vision/detected_marker.h"

namespace mirrorarm::vision {

/// A disc seen by both cameras, or a pair of discs that may be one: where several pairs claim the same disc
/// of an image all are told, for only the model of a target can decide.
struct StereoPoint {
  Eigen::Vector3d p_C = Eigen::Vector3d::Zero();  ///< centre in the left camera [m]
  Eigen::Matrix3d covariance_m2 = Eigen::Matrix3d::Zero();
  int left = -1;             ///< index into the left image's markers
  int right = -1;            ///< index into the right image's markers
  double epipolar_px = 0.0;  ///< distance of the right centre from the left one's epipolar line
  Eigen::Vector2d left_px = Eigen::Vector2d::Zero();   ///< the physical disc's centre in the left raw image,
  Eigen::Vector2d right_px = Eigen::Vector2d::Zero();  ///< and in the right one: what p_C stands on
  /// The disc's normal, towards the cameras, and radius, from its two outlines; zero when they do not tell.
  Eigen::Vector3d normal_C = Eigen::Vector3d::Zero();
  double radius_m = 0.0;
  double support = 0.0;   ///< what neighbours within the disparity gradient limit say for it (paper eq. 11)
  int rivals = 0;         ///< other pairs that claim one of its two discs
  bool preferred = true;  ///< none of them is better supported: the one to take when no model decides
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
