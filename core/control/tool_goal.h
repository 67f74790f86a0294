#pragma once

#include "core/common/time.h"
#include "core/geometry/rigid_transform.h"

namespace mirrorarm::control {

/// Where the end effector E belongs, now and a moment later: a goal with a speed. Poses in base B.
struct ToolGoal {
  RigidTransform X_BE = RigidTransform::Identity();
  RigidTransform X_BE_soon = RigidTransform::Identity();  ///< `soon` later
  Seconds soon{0.020};

  /// One that does not move.
  static ToolGoal resting(const RigidTransform& X_BE) { return {X_BE, X_BE}; }
};

}  // namespace mirrorarm::control
