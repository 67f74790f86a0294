#pragma once

#include <algorithm>

#include "core/devices/fri_datagram.h"
#include "core/robot/joints.h"

namespace mirrorarm::devices {

/// Seven numbers of the wire as the rest of the program writes joints, and back.
[[nodiscard]] inline robot::Joints jointsOf(const FriJoints& values) {
  return Eigen::Map<const Eigen::Matrix<float, kFriJoints, 1>>(values.data()).cast<double>();
}

/// `q` has seven numbers.
[[nodiscard]] inline FriJoints friJointsOf(const robot::Joints& q) {
  FriJoints values{};
  std::transform(q.begin(), q.end(), values.begin(), [](double x) { return static_cast<float>(x); });
  return values;
}

/// Where the controller holds the arm: its own command and what the host has added to it.
[[nodiscard]] inline robot::Joints heldBy(const FriMeasurement& measurement) {
  return jointsOf(measurement.commanded_q_rad) + jointsOf(measurement.commanded_q_offset_rad);
}

}  // namespace mirrorarm::devices
