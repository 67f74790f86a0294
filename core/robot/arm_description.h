#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/geometry/rigid_transform.h"
#include "core/robot/joints.h"

namespace mirrorarm::robot {

/// One turning joint, as the URDF says.
struct JointDescription {
  std::string name;
  double lower_rad = 0.0;
  double upper_rad = 0.0;
  double max_speed_rad_s = 0.0;
  double max_torque_nm = 0.0;
  RigidTransform X_parent = RigidTransform::Identity();  ///< joint frame in the link before, at angle 0
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();       ///< in the joint frame
};

/// What a shape belongs to.
enum class ArmPart : std::uint8_t { kLink, kCameraBar, kSling };
/// "link", "camera_bar", "sling"
[[nodiscard]] std::string_view id(ArmPart part);

/// A cylinder with round ends around the segment from `a` to `b`, fixed to a link. Collision and drawing
/// shape.
struct Capsule {
  int link = 0;                                 ///< 0 the base, i the link after joint i
  Eigen::Vector3d a = Eigen::Vector3d::Zero();  ///< in the link's frame [m]
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  double radius_m = 0.0;
  ArmPart part = ArmPart::kLink;
};

/// A serial arm of turning joints. Frames: B base, F flange.
struct ArmDescription {
  std::string name;
  std::vector<JointDescription> joints;                  ///< base to flange
  RigidTransform X_last_F = RigidTransform::Identity();  ///< flange in the last joint's frame
  std::vector<Capsule> shapes;

  [[nodiscard]] int jointCount() const { return static_cast<int>(joints.size()); }
};

}  // namespace mirrorarm::robot
