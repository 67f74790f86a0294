#include "core/control/follower.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace mirrorarm::control {
namespace {

using robot::Joints;
using robot::MotionState;
using robot::Trajectory;

constexpr double kOffTrajectory_rad = 0.005;  // further from the motion in force: it is not being followed
constexpr double kCheckEvery_rad = 0.02;      // of the finished motion, for collisions
constexpr int kToolSamples = 24;
constexpr int kToolRounds = 4;
constexpr double kToolSlack = 1.001;
constexpr double kPosturePull = 0.02;  // of the way to the first posture, each step
constexpr double kInside = 0.99;  // share of the limits that is planned with; the guard enforces the rest

double largest(const Joints& q) { return q.cwiseAbs().maxCoeff(); }

/// The arm with the joint ranges of the limits, so that inverse kinematics answers inside them.
robot::ArmDescription within(const robot::MotionLimits& limits, robot::ArmDescription arm) {
  for (int j = 0; j < arm.jointCount(); ++j) {
    arm.joints[static_cast<std::size_t>(j)].lower_rad = limits.lower_rad[j];
    arm.joints[static_cast<std::size_t>(j)].upper_rad = limits.upper_rad[j];
  }
  return arm;
}

robot::MotionLimits inside(robot::MotionLimits limits) {
  limits.max_speed_rad_s *= kInside;
  limits.max_acceleration_rad_s2 *= kInside;
  limits.max_tool_speed_m_s *= kInside;
  limits.max_tool_acceleration_m_s2 *= kInside;
  return limits;
}

FollowOutcome outcomeOf(robot::PlanError error) {
  return error == robot::PlanError::kJointRange ? FollowOutcome::kJointRange : FollowOutcome::kBlocked;
}

}  // namespace

struct Follower::Body {
  Body(const robot::ArmDescription& arm, const RigidTransform& sling, const robot::MotionLimits& profile,
       robot::Planner collision_planner, const FollowerSettings& chosen)
      : X_EF(sling.inverse()),
        limits(inside(profile)),
        settings(chosen),
        kinematics(within(profile, arm)),
        planner(std::move(collision_planner)) {}

  [[nodiscard]] bool isFollowed(const MotionState& commanded, TimePoint now) const {
    return in_force.valid() && largest(in_force.at(now).q_rad - commanded.q_rad) < kOffTrajectory_rad;
  }

  [[nodiscard]] bool isInDeadBand(const RigidTransform& X_BE) const {
    return (X_BE.translation() - last_goal.translation()).norm() < settings.dead_band_m &&
           angleBetween(X_BE, last_goal) < settings.dead_band_rad;
  }

  /// Where inverse kinematics starts. From the last goal, so that the same question gets the same answer;
  /// drawn a little towards the posture in which following began, because the redundant joint of a closed
  /// movement would wander off otherwise.
  [[nodiscard]] Joints seed(const MotionState& commanded, bool followed) {
    if (!in_force.valid()) posture = commanded.q_rad;
    const Joints near = followed ? in_force.goal() : commanded.q_rad;
    return near + kPosturePull * (posture - near);
  }

  FollowStep towards(const RigidTransform& X_BE, const MotionState& commanded, const Joints& seed,
                     TimePoint now) {
    const auto goal = kinematics.inverse(X_BE * X_EF, seed);
    if (!goal) return {FollowOutcome::kOutOfReach, {}};
    if (largest(*goal - commanded.q_rad) > settings.max_joint_step_rad)
      return {FollowOutcome::kJointRange, {}};
    const auto path = planner.plan(commanded.q_rad, *goal);
    if (!path) return {outcomeOf(path.error().why), {}};
    const Trajectory motion = timed(commanded, path->waypoints, now);
    // From a moving start the motion bends off the straight line that was checked.
    if (!isClear(motion)) return {FollowOutcome::kBlocked, {}};
    return {path->direct ? FollowOutcome::kDirect : FollowOutcome::kPlanned, motion};
  }

  /// As fast as joints and tool allow.
  [[nodiscard]] Trajectory timed(const MotionState& from, std::span<const Joints> waypoints,
                                 TimePoint now) const {
    Seconds at_least(0.0);
    Trajectory motion = Trajectory::through(from, waypoints, now, limits);
    for (int round = 0; round < kToolRounds; ++round) {
      const double excess = toolExcess(motion);
      if (excess <= kToolSlack) break;
      at_least = excess * motion.duration();
      motion = Trajectory::through(from, waypoints, now, limits, at_least);
    }
    return motion;
  }

  [[nodiscard]] Eigen::Vector3d toolSpeed(const MotionState& state) const {
    return kinematics.jacobian(state.q_rad).topRows<3>() * state.v_rad_s;
  }

  /// By how much the motion must be slower for the flange to keep its limits; 1 and less: it does. What the
  /// moving start already has cannot be mended by time.
  [[nodiscard]] double toolExcess(const Trajectory& motion) const {
    const Seconds step = motion.duration() / kToolSamples;
    Eigen::Vector3d last = toolSpeed(motion.at(motion.start()));
    const double speed_limit = std::max(limits.max_tool_speed_m_s, last.norm());
    double acceleration_limit = limits.max_tool_acceleration_m_s2;
    double excess = 0.0;
    for (int i = 1; i <= kToolSamples; ++i) {
      const Eigen::Vector3d v = toolSpeed(motion.at(motion.start() + toClock(i * step)));
      const double acceleration = (v - last).norm() / step.count();
      if (i == 1) acceleration_limit = std::max(acceleration_limit, acceleration);
      excess = std::max({excess, v.norm() / speed_limit, std::sqrt(acceleration / acceleration_limit)});
      last = v;
    }
    return excess;
  }

  [[nodiscard]] bool isClear(const Trajectory& motion) const {
    const double fastest = limits.max_speed_rad_s.maxCoeff();
    const int samples = 1 + static_cast<int>(motion.duration().count() * fastest / kCheckEvery_rad);
    for (int i = 1; i <= samples; ++i) {
      const auto t = motion.start() + toClock(motion.duration() * (static_cast<double>(i) / samples));
      if (planner.collides(motion.at(t).q_rad)) return false;
    }
    return true;
  }

  RigidTransform X_EF;
  robot::MotionLimits limits;
  FollowerSettings settings;
  robot::Kinematics kinematics;
  robot::Planner planner;
  Joints posture;  // in which following began
  Trajectory in_force;
  RigidTransform last_goal = RigidTransform::Identity();  // good while `in_force` is valid
};

Follower::Follower(const robot::ArmDescription& arm, const RigidTransform& X_FE,
                   const robot::MotionLimits& limits, robot::Planner planner,
                   const FollowerSettings& settings)
    : body_(std::make_unique<Body>(arm, X_FE, limits, std::move(planner), settings)) {}
Follower::~Follower() = default;

FollowStep Follower::step(const RigidTransform& X_BE_goal, const MotionState& commanded, TimePoint now) {
  const bool followed = body_->isFollowed(commanded, now);
  if (followed && body_->isInDeadBand(X_BE_goal)) return {FollowOutcome::kHeld, {}};
  FollowStep step = body_->towards(X_BE_goal, commanded, body_->seed(commanded, followed), now);
  if (step.isNew()) {
    body_->in_force = step.trajectory;
    body_->last_goal = X_BE_goal;
  }
  return step;
}

void Follower::reset() { body_->in_force = {}; }

std::string_view id(FollowOutcome outcome) {
  switch (outcome) {
    case FollowOutcome::kDirect:
      return "direct";
    case FollowOutcome::kPlanned:
      return "planned";
    case FollowOutcome::kHeld:
      return "held";
    case FollowOutcome::kOutOfReach:
      return "out_of_reach";
    case FollowOutcome::kBlocked:
      return "blocked";
    case FollowOutcome::kJointRange:
      return "joint_range";
  }
  return "unknown";
}

}  // namespace mirrorarm::control
