#pragma once

#include <stop_token>

#include "core/control/servo_loop.h"
#include "core/robot/robot_link.h"

namespace mirrorarm::station {

/// The servo thread: asks for real time and says what it got, steps `servo` once a cycle of the robot until
/// asked to stop, and leaves the robot at rest.
void runServo(const std::stop_token& stop, control::ServoLoop& servo, robot::RobotLink& robot);

}  // namespace mirrorarm::station
