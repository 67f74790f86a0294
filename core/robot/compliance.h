#pragma once

#include <cstdint>
#include <string_view>

#include <Eigen/Core>

#include "core/robot/joints.h"

namespace mirrorarm::robot {

/// How an arm answers a force: it holds its position, or gives way like springs in its joints or like one
/// spring at its tool.
enum class GivesWay : std::uint8_t { kNot, kInJoints, kAtTool };
/// "not", "in_joints", "at_tool".
[[nodiscard]] std::string_view id(GivesWay gives_way);

/// The springs about the commanded position, and their damping as a share of the critical one. Joints:
/// Nm/rad. Tool: along x, y, z [N/m], then about x, y, z [Nm/rad], in the flange's frame.
struct Compliance {
  Joints joint_stiffness_nm_rad{};
  double joint_damping = 0.7;
  Eigen::Matrix<double, 6, 1> tool_stiffness = Eigen::Matrix<double, 6, 1>::Zero();
  double tool_damping = 0.7;
};

}  // namespace mirrorarm::robot
