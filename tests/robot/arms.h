#pragma once

#include <random>

#include "core/robot/arm_description.h"
#include "core/robot/joints.h"
#include "core/robot/urdf.h"

namespace mirrorarm::robot::testing {

inline ArmDescription arm(const std::string& name) {
  const auto read = readUrdf(std::string(RESOURCES) + "/robots/" + name + ".urdf");
  if (!read) throw std::runtime_error(describe(read.error()));
  return *read;
}

inline ArmDescription lbr() { return arm("lbr4plus"); }

/// One of the joint positions within `share` of each range.
inline Joints randomJoints(const ArmDescription& arm, std::mt19937& random, double share) {
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  Joints q(arm.jointCount());
  for (int i = 0; i < arm.jointCount(); ++i) {
    const auto& joint = arm.joints[static_cast<std::size_t>(i)];
    q[i] = 0.5 * (joint.lower_rad + joint.upper_rad) +
           unit(random) * share * 0.5 * (joint.upper_rad - joint.lower_rad);
  }
  return q;
}

/// The bent-elbow posture in which the bench works.
inline Joints working() { return (Joints(7) << 0.0, -0.6, 0.0, 1.4, 0.0, 1.0, 0.0).finished(); }

}  // namespace mirrorarm::robot::testing
