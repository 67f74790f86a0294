#pragma once

#include "core/camera/stereo_rig.h"
#include "core/control/tool_goal.h"

namespace mirrorarm::control {

/// What the cameras on the hand look at: a ball around the target's markers, in base B.
struct Sight {
  Eigen::Vector3d centre_B = Eigen::Vector3d::Zero();
  double radius_m = 0.06;
};

/// Keeps the target inside both cameras' images. The cameras ride on the robot's hand: a goal that follows
/// the target keeps it in view by itself, one that mirrors its movement may look away. One thread; does not
/// allocate.
class Gaze {
 public:
  /// `X_EC`: camera in the end effector's frame.
  Gaze(const camera::StereoRig& rig, const RigidTransform& X_EC);

  /// How far the ball stays inside both images when the end effector stands at `X_BE` [px]: negative outside,
  /// minus infinity where a camera cannot see so far aside at all.
  [[nodiscard]] double margin_px(const RigidTransform& X_BE, const Sight& sight) const;

  /// Whether it stays far enough inside both.
  [[nodiscard]] bool sees(const RigidTransform& X_BE, const Sight& sight) const;

  struct Kept {
    ToolGoal goal;
    bool shortened = false;  ///< the goal would have lost the target
  };
  /// `goal`, or the part of the way there from `X_BE_now` on which the target stays in view, at the same
  /// share of the goal's speed. From where it is (nearly) lost already, only goals that see it better.
  [[nodiscard]] Kept keep(const ToolGoal& goal, const RigidTransform& X_BE_now, const Sight& sight) const;

 private:
  camera::StereoRig rig_;
  RigidTransform X_CE_;
};

}  // namespace mirrorarm::control
