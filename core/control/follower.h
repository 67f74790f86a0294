#pragma once

#include <cstdint>
#include <memory>
#include <string_view>

#include "core/common/time.h"
#include "core/geometry/rigid_transform.h"
#include "core/robot/kinematics.h"
#include "core/robot/planner.h"
#include "core/robot/trajectory.h"

namespace mirrorarm::control {

/// How one follower step came out.
enum class FollowOutcome : std::uint8_t { kDirect, kPlanned, kHeld, kOutOfReach, kBlocked, kJointRange };
/// "direct", "planned", "held", ...
[[nodiscard]] std::string_view id(FollowOutcome outcome);

struct FollowerSettings {
  Seconds period{0.040};        ///< between two steps (paper: 40 ms)
  double dead_band_m = 0.0005;  ///< goals nearer than this to the last one start no new trajectory
  double dead_band_rad = 0.002;
  double max_joint_step_rad =
      1.0;  ///< a goal further away in one joint is rejected (paper: movement range check)
};

struct FollowStep {
  FollowOutcome outcome = FollowOutcome::kHeld;
  robot::Trajectory trajectory;  ///< new motion, unless held or rejected: then the one before stays in force
  [[nodiscard]] bool isNew() const {
    return outcome == FollowOutcome::kDirect || outcome == FollowOutcome::kPlanned;
  }
};

/// Turns goals for the end effector into joint trajectories: inverse kinematics near the present joints,
/// direct check, a plan only if that is blocked, joint-range rejection, quintic from the commanded state.
/// Source: paper section 2.4. Control thread only.
class Follower {
 public:
  Follower(const robot::ArmDescription& arm, const RigidTransform& X_FE, const robot::MotionLimits& limits,
           robot::Planner planner, const FollowerSettings& settings);
  ~Follower();

  /// `commanded` is the state sent to the robot at `now`; the new motion starts there.
  [[nodiscard]] FollowStep step(const RigidTransform& X_BE_goal, const robot::MotionState& commanded,
                                TimePoint now);

  /// Forgets the last goal, so that the next one starts a trajectory however near it is.
  void reset();

 private:
  struct Body;
  std::unique_ptr<Body> body_;
};

}  // namespace mirrorarm::control
