#pragma once

#include <cstdint>
#include <optional>

#include "core/common/time.h"
#include "core/devices/fri_datagram.h"
#include "core/robot/arm_description.h"
#include "core/robot/compliance.h"

namespace mirrorarm::devices {

/// How host and KRL program agree by the integers that they share, counted from 1 as KRL does.
struct FriHandshake {
  int control_request = 1;  ///< $FRI_FRM_INT[]: wanted control: 10 position, 20 tool, 30 joint impedance
  int start_request = 2;    ///< $FRI_FRM_INT[]: `start` or `stop`
  std::int32_t start = 1;
  std::int32_t stop = 0;
  int echo = 2;  ///< $FRI_TO_INT[]: the request that the program has heeded last; 0 where it says none
};

/// What a FriSession goes by. The quality's thresholds are not published, so they are settings.
struct FriSettings {
  Seconds period{0.001};  ///< what the program on the controller gives friOpen
  FriHandshake handshake{};
  robot::GivesWay gives_way = robot::GivesWay::kNot;
  std::optional<robot::ArmDescription> arm{};  ///< of seven joints; needed to give way at the tool
  /// In force until a command brings its own.
  robot::Compliance compliance{robot::Joints::Constant(kFriJoints, 1000.0), 0.7,
                               (Eigen::Matrix<double, 6, 1>() << 2000, 2000, 2000, 200, 200, 200).finished(),
                               0.7};
  FriQuality quality_to_start = FriQuality::kPerfect;
  FriQuality quality_to_move = FriQuality::kOk;
  Seconds start_patience{10.0};  ///< for the program on the controller to start
  Seconds settle{0.012};         ///< one cycle of the controller's own interpolation, at rest, before moving
  Seconds silent_after{0.050};
  int lost_in_a_row = 1;              ///< the controller bridges so many, not more
  double start_tolerance_rad = 0.02;  ///< between what the controller holds and where the motion begins
  /// Of one command to the next; the lower of the published figures of each joint.
  robot::Joints max_speed_rad_s =
      (robot::Joints(kFriJoints) << 1.919, 1.919, 1.963, 1.963, 3.141, 1.963, 1.963).finished();
  double braking_rad_s2 = 4.0;  ///< of the fastest joint, where no command comes any more
};

}  // namespace mirrorarm::devices
