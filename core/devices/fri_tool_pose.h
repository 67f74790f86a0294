#pragma once

#include <array>

#include "core/robot/kinematics.h"

namespace mirrorarm::devices {

/// The pose that a controller under Cartesian impedance is to be given along with joint angles: while it
/// monitors the one that it measures, then that one moved as the angles move the flange. The controller's
/// tool may be any; its base is the arm's. One thread; does not allocate.
class FriToolPose {
 public:
  using Wire = std::array<float, 12>;  ///< 3x4, row by row [m]

  explicit FriToolPose(const robot::ArmDescription& arm) : kinematics_(arm) {}

  /// The controller measures `tool` where the arm is held at `q_rad`.
  void mirror(const robot::Joints& q_rad, const Wire& tool) noexcept;
  /// For the arm at `q_rad`; what was mirrored for the angles that it was mirrored at.
  [[nodiscard]] Wire at(const robot::Joints& q_rad) const noexcept;

 private:
  robot::Kinematics kinematics_;
  RigidTransform X_FT_ = RigidTransform::Identity();  ///< the controller's tool in the flange
};

}  // namespace mirrorarm::devices
