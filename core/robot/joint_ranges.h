#pragma once

#include "core/robot/arm_description.h"
#include "core/robot/joints.h"

namespace mirrorarm::robot {

/// Joint ranges [rad].
struct JointRanges {
  Joints lower, upper;
  [[nodiscard]] bool have(const Joints& q) const {
    return (q.array() >= lower.array()).all() && (q.array() <= upper.array()).all();
  }
};
[[nodiscard]] JointRanges jointRanges(const ArmDescription& arm);

}  // namespace mirrorarm::robot
