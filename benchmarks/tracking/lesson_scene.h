#pragma once

#include <optional>
#include <vector>

#include "benchmarks/tracking/marker_world.h"
#include "core/camera/stereo_rig.h"

namespace mirrorarm::benchmarks::tracking {

/// Standard deviation of a disc's centre in an image, per axis.
inline constexpr double kCentreNoise_px = 0.02;

/// A point as the rig measures it: both its images with noise, triangulated, with covariance. Nothing where a
/// lens does not see it.
[[nodiscard]] std::optional<mirrorarm::tracking::CloudPoint> measuredPoint(const camera::StereoRig& rig,
                                                                           const Eigen::Vector3d& p_C,
                                                                           TrialRandom& random);

/// One frame of a lesson, with its truth.
struct LessonFrame {
  RigidTransform X_CT = RigidTransform::Identity();
  std::vector<mirrorarm::tracking::CloudPoint> cloud;
  std::vector<int> marker_of_point;  ///< -1 a stranger
};

/// A body of ten markers that swings and turns at 0.4 m before the rig, 24 frames a second. In every other
/// frame one to five of its markers are hidden; three strangers stand still, two are anywhere else in each
/// frame.
struct LessonScene {
  Layout markers_T;
  std::vector<LessonFrame> frames;
};
[[nodiscard]] LessonScene lessonScene(const camera::StereoRig& rig, int frames, TrialRandom& random);

}  // namespace mirrorarm::benchmarks::tracking
