#pragma once

#include <array>
#include <optional>

#include "core/robot/arm_description.h"

namespace mirrorarm::robot {

inline constexpr int kSrsJoints = 7;

/// An arm built like a human one: three axes that meet in the shoulder S, a bending axis in the elbow E,
/// three axes that meet in the wrist W, no offsets between. At angle zero it is stretched out: axes 1, 3, 5
/// and 7 lie on one line, axes 2, 4 and 6 across it and parallel. LBR 4+ and LBR iiwa are such arms. Frame U:
/// origin in the shoulder, z towards the stretched wrist, y along axis 2. There the joints turn about z, y,
/// z, y, z, y, z by the angles sign[i] * q[i].
struct SrsArm {
  double upper_arm_m = 0.0;                          ///< shoulder to elbow
  double forearm_m = 0.0;                            ///< elbow to wrist
  std::array<double, kSrsJoints> sign{};             ///< +1 or -1
  RigidTransform X_UB = RigidTransform::Identity();  ///< base in U
  RigidTransform X_FW =
      RigidTransform::Identity();  ///< the wrist, parallel to U at angle zero, in the flange
  Eigen::Vector3d ahead_U = Eigen::Vector3d::UnitX();  ///< x of the base, made level in U: where work is done
};

/// Nothing when the arm is built otherwise (by more than 1e-7 m or 1e-7 rad).
[[nodiscard]] std::optional<SrsArm> srsArm(const ArmDescription& arm);

}  // namespace mirrorarm::robot
