#pragma once

#include "core/camera/stereo_rig.h"

namespace mirrorarm::vision {

/// A rig as the paper's: 1296x964, 120 mm apart, turned a little towards each other.
inline camera::StereoRig benchRig(camera::LensModel model) {
  const bool fisheye = model == camera::LensModel::kKannalaBrandt;
  camera::Intrinsics left{model, 1296, 964, 720.9, 719.4, 651.7, 478.3, {-0.21, 0.045, 0, 0, 0}};
  if (fisheye) left = {model, 1296, 964, 551.2, 550.7, 640.1, 490.4, {-0.01, 0.002, -5e-4, 1e-4, 0}};
  camera::Intrinsics right = left;
  right.cx_px += 4.1;
  right.cy_px -= 6.3;
  camera::StereoRig rig;
  rig.left = camera::CameraModel(left);
  rig.right = camera::CameraModel(right);
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.03, Eigen::Vector3d(0.1, 1.0, 0.05).normalized()));
  rig.X_RC = makeTransform(turn, Eigen::Vector3d(-0.12, 0.001, 0.002));
  return rig;
}

}  // namespace mirrorarm::vision
