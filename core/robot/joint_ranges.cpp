#include "core/robot/joint_ranges.h"

namespace mirrorarm::robot {

JointRanges jointRanges(const ArmDescription& arm) {
  JointRanges ranges{Joints(arm.jointCount()), Joints(arm.jointCount())};
  for (int i = 0; i < arm.jointCount(); ++i) {
    ranges.lower[i] = arm.joints[static_cast<std::size_t>(i)].lower_rad;
    ranges.upper[i] = arm.joints[static_cast<std::size_t>(i)].upper_rad;
  }
  return ranges;
}

}  // namespace mirrorarm::robot
