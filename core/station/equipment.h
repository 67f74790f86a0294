#pragma once

#include <vector>

#include "core/camera/frame_source.h"
#include "core/camera/stereo_rig.h"
#include "core/robot/arm_description.h"
#include "core/robot/obstacle.h"
#include "core/robot/robot_link.h"

namespace mirrorarm::station {

/// The devices and calibrations that a station works with, real or simulated. All outlive the station.
struct Equipment {
  camera::FrameSource* cameras = nullptr;
  robot::RobotLink* robot = nullptr;
  camera::StereoRig rig;
  robot::ArmDescription arm;
  std::vector<robot::Capsule> attached;              ///< camera bar and sling, fixed to the flange
  std::vector<robot::Obstacle> obstacles;            ///< what the arm must not touch, in base B
  RigidTransform X_FC = RigidTransform::Identity();  ///< camera on the flange (hand-eye)
  RigidTransform X_FE = RigidTransform::Identity();  ///< sling on the flange
  Seconds clock_offset{0.0};  ///< add it to a frame's time to have the robot's time of the same moment
  bool simulated = false;
  bool calibration_holds = true;  ///< false: the robot is not to follow; see calibrated()
};

}  // namespace mirrorarm::station
