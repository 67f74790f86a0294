#include "core/devices/fri_tool_pose.h"

#include <cstddef>

namespace mirrorarm::devices {

void FriToolPose::mirror(const robot::Joints& q_rad, const Wire& tool) noexcept {
  RigidTransform X_BT = RigidTransform::Identity();
  for (std::size_t i = 0; i < tool.size(); ++i)
    X_BT(static_cast<Eigen::Index>(i / 4), static_cast<Eigen::Index>(i % 4)) = tool[i];
  X_FT_ = kinematics_.flange(q_rad).inverse() * X_BT;
}

FriToolPose::Wire FriToolPose::at(const robot::Joints& q_rad) const noexcept {
  const RigidTransform X_BT = kinematics_.flange(q_rad) * X_FT_;
  Wire tool{};
  for (std::size_t i = 0; i < tool.size(); ++i)
    tool[i] = static_cast<float>(X_BT(static_cast<Eigen::Index>(i / 4), static_cast<Eigen::Index>(i % 4)));
  return tool;
}

}  // namespace mirrorarm::devices
