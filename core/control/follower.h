#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>

#include "core/common/time.h"
#include "core/control/planning_desk.h"
#include "core/control/tool_goal.h"
#include "core/robot/collision.h"
#include "core/robot/kinematics.h"
#include "core/robot/trajectory.h"

namespace mirrorarm::control {

/// How one follower step came out.
enum class FollowOutcome : std::uint8_t {
  kDirect,      ///< straight onto the goal
  kPlanned,     ///< a way around something begins
  kHeld,        ///< what is in force goes on: the way around, or rest
  kPlanning,    ///< the straight way is blocked, another one is being looked for; the arm comes to rest
  kOutOfReach,  ///< no joints bring the end effector there
  kBlocked,     ///< something stands in the way and there is no way around it
  kJointRange,  ///< a joint would have to move too far
};
/// "direct", "planned", "held", ...
[[nodiscard]] std::string_view id(FollowOutcome outcome);

struct FollowerSettings {
  double max_joint_step_rad =
      1.0;  ///< a goal further away in one joint is rejected (paper: movement range check)
  /// Two frames to catch up with what noise there is; three lost frames until the arm comes to rest.
  robot::PursuitTimes times{.catch_up = Seconds(0.083), .horizon = Seconds(0.150)};
  /// A new motion begins so long after the state that it was planned from: until then it reaches the servo
  /// loop, which goes on with the motion before.
  Seconds handover{0.002};
};

struct FollowStep {
  FollowOutcome outcome = FollowOutcome::kHeld;
  robot::Trajectory trajectory{};           ///< new motion; else the one before stays in force
  std::optional<PlanQuestion> question{};   ///< to be laid on the planning desk
  std::optional<robot::Contact> contact{};  ///< what meets what, where blocked and known
  [[nodiscard]] bool isNew() const {
    return outcome == FollowOutcome::kDirect || outcome == FollowOutcome::kPlanned;
  }
};

/// Turns goals for the end effector into joint motions: inverse kinematics near the present posture, straight
/// onto the goal if nothing is in the way, else around it once a way was planned; joint-range rejection.
/// Every motion starts from the commanded state, is checked against collisions to its end before it is given
/// away, and ends at rest by itself. Source: paper section 2.4. Control thread only; does not wait for a
/// plan.
class Follower {
 public:
  Follower(const robot::ArmDescription& arm, const RigidTransform& X_FE, const robot::MotionLimits& limits,
           robot::CollisionWorld world, const FollowerSettings& settings);
  ~Follower();

  /// A new goal, as it is at `now` + handover. `commanded` is the state sent to the robot at `now`.
  [[nodiscard]] FollowStep step(const ToolGoal& goal, const robot::MotionState& commanded, TimePoint now);

  /// What the planning desk says. An answer to another question than the last one is passed over.
  [[nodiscard]] FollowStep take(const PlanAnswer& answer, const robot::MotionState& commanded, TimePoint now);

  /// Forgets what was followed: the way around something, the open question.
  void reset();

  /// End effector in base.
  [[nodiscard]] RigidTransform X_BE(const robot::Joints& q_rad) const;

 private:
  struct Body;
  std::unique_ptr<Body> body_;
};

}  // namespace mirrorarm::control
