#pragma once

#include <span>

#include "core/robot/kinematics.h"
#include "core/robot/trajectory.h"

namespace mirrorarm::control {

/// Plans motions that keep the limits of the joints (robot::Trajectory) and those of the flange's origin:
/// where a motion would move it faster, all joints go slower. What the moving start already exceeds cannot be
/// mended. A hair inside the limits, so that the motion guard has nothing to do. One thread.
class MotionTimer {
 public:
  MotionTimer(const robot::ArmDescription& arm, const robot::MotionLimits& limits);

  [[nodiscard]] robot::Trajectory pursuit(const robot::MotionState& from, const robot::MovingGoal& goal,
                                          TimePoint start, const robot::PursuitTimes& times) const;
  [[nodiscard]] robot::Trajectory through(const robot::MotionState& from,
                                          std::span<const robot::Joints> waypoints, TimePoint start) const;

 private:
  /// How far the flange goes beyond its limits, as shares of them: 1 and less it keeps them.
  struct Excess {
    double speed = 0.0;
    double acceleration = 0.0;
  };
  [[nodiscard]] Excess excessOf(const robot::Trajectory& motion) const;
  /// What the flange's origin does in base when the joints do so: speeds, or accelerations without those of
  /// turning itself.
  [[nodiscard]] Eigen::Vector3d flangeMotion(const robot::Joints& q_rad, const robot::Joints& joints) const;

  robot::MotionLimits limits_;
  robot::Kinematics kinematics_;
};

}  // namespace mirrorarm::control
