#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/camera/stereo_frame.h"
#include "core/camera/stereo_rig.h"

namespace mirrorarm::benchmarks::vision {

/// A frame of the simulated sensors and where its discs are.
struct MovingFrame {
  camera::StereoFrame frame;
  std::vector<Eigen::Vector3d> discs_C;
};

/// A target of ten 7 mm discs on a half cylinder of 45 mm radius, 0.4 m before the fisheye rig, swinging by
/// 50 mm and 15 degrees at up to 0.2 m/s: `count` different frames with the movement's blur.
[[nodiscard]] std::vector<MovingFrame> movingTarget(const camera::StereoRig& rig, int count);

/// Eighty discs and twenty spurious strips, blotches and specks at 0.3 to 0.6 m; each frame others.
[[nodiscard]] std::vector<MovingFrame> crowdedScene(const camera::StereoRig& rig, int count);

}  // namespace mirrorarm::benchmarks::vision
