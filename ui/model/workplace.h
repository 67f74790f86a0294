#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/calibration/validity.h"
#include "core/camera/stereo_rig.h"
#include "core/robot/arm_description.h"
#include "core/robot/motion_limits.h"

namespace mirrorarm::ui {

/// What the screen knows of the equipment: values copied once, no device. Frames as in station::Equipment.
struct Workplace {
  camera::StereoRig rig;
  robot::ArmDescription arm;
  robot::MotionLimits limits;            ///< the profile in force
  std::vector<robot::Capsule> attached;  ///< camera bar and sling, fixed to the last link
  RigidTransform X_FC = RigidTransform::Identity();
  RigidTransform X_FE = RigidTransform::Identity();
  Eigen::Vector3d impaired_elbow_B{1.05, 0.0, 0.28};  ///< where the impaired arm comes from
  /// How those in force stand; nothing where exact ones come with the simulated devices.
  std::optional<calibration::Validity> calibrations;
  bool simulated = false;
};

}  // namespace mirrorarm::ui
