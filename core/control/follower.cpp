#include "core/control/follower.h"

#include <algorithm>
#include <limits>

#include "core/control/motion_timer.h"

namespace mirrorarm::control {
namespace {

using robot::Joints;
using robot::MotionState;
using robot::MovingGoal;
using robot::Trajectory;

constexpr double kExactly_rad = 1e-6;         // nearer to the motion in force: the guard let it pass
constexpr double kOffTrajectory_rad = 0.005;  // further from the motion in force: it is not being followed
constexpr double kCheckEvery_rad = 0.02;      // of the finished motion, for collisions
constexpr double kFinest_rad = 0.002;         // where no step can be proven clear
constexpr double kSameEnd_rad = 0.05;         // a detour whose end is this near the goal is gone to its end

double largest(const Joints& q) { return q.cwiseAbs().maxCoeff(); }

/// The arm with the joint ranges of the limits, so that inverse kinematics answers inside them.
robot::ArmDescription within(const robot::MotionLimits& limits, robot::ArmDescription arm) {
  for (int j = 0; j < arm.jointCount(); ++j) {
    arm.joints[static_cast<std::size_t>(j)].lower_rad = limits.lower_rad[j];
    arm.joints[static_cast<std::size_t>(j)].upper_rad = limits.upper_rad[j];
  }
  return arm;
}

FollowOutcome outcomeOf(robot::PlanError error) {
  return error == robot::PlanError::kJointRange ? FollowOutcome::kJointRange : FollowOutcome::kBlocked;
}

}  // namespace

struct Follower::Body {
  Body(const robot::ArmDescription& arm, const RigidTransform& sling, const robot::MotionLimits& profile,
       robot::CollisionWorld collisions, const FollowerSettings& chosen)
      : X_FE(sling),
        X_EF(sling.inverse()),
        settings(chosen),
        fastest_rad_s(profile.max_speed_rad_s.maxCoeff()),
        kinematics(within(profile, arm)),
        timer(arm, profile),
        world(std::move(collisions)) {}

  [[nodiscard]] double distanceFromMotion(const MotionState& commanded, TimePoint now) const {
    return in_force.valid() ? largest(in_force.at(now).q_rad - commanded.q_rad)
                            : std::numeric_limits<double>::infinity();
  }

  /// What will be commanded when the next motion begins.
  [[nodiscard]] MotionState atHandover(const MotionState& commanded, TimePoint now) const {
    if (distanceFromMotion(commanded, now) < kExactly_rad)
      return in_force.at(now + toClock(settings.handover));
    const double t = settings.handover.count();
    return {commanded.q_rad + t * commanded.v_rad_s + 0.5 * t * t * commanded.a_rad_s2,
            commanded.v_rad_s + t * commanded.a_rad_s2, commanded.a_rad_s2};
  }

  /// Where inverse kinematics starts. From the last goal, so that the same question gets the same answer.
  [[nodiscard]] Joints seed(const MotionState& commanded, TimePoint now) const {
    return distanceFromMotion(commanded, now) < kOffTrajectory_rad ? last_goal : commanded.q_rad;
  }

  [[nodiscard]] std::optional<MovingGoal> jointGoal(const ToolGoal& goal, const Joints& near) const {
    const auto q = kinematics.inverse(goal.X_BE * X_EF, near);
    if (!q) return std::nullopt;
    // From the same seed, so that what the choice of a posture adds by itself is no speed.
    const auto soon = kinematics.inverse(goal.X_BE_soon * X_EF, near);
    return MovingGoal{*q, soon ? Joints((*soon - *q) / goal.soon.count()) : Joints::Zero(q->size())};
  }

  [[nodiscard]] bool isOnDetour(TimePoint now) const {
    return on_detour && now < in_force.end() && largest(last_goal - in_force.goal()) < kSameEnd_rad;
  }

  FollowStep towards(const MovingGoal& goal, const MotionState& from, TimePoint start) {
    if (largest(goal.q_rad - from.q_rad) > settings.max_joint_step_rad)
      return {.outcome = FollowOutcome::kJointRange};
    const Trajectory motion = timer.pursuit(from, goal, start, settings.times);
    if (const auto contact = contactOn(motion)) return ask(from.q_rad, goal.q_rad, contact);
    on_detour = false;
    question.reset();
    in_force = motion;
    return {.outcome = FollowOutcome::kDirect, .trajectory = motion};
  }

  /// One question at a time: the next is asked when this one is answered.
  FollowStep ask(const Joints& from, const Joints& to, const std::optional<robot::Contact>& contact) {
    FollowStep step{.outcome = refused.value_or(FollowOutcome::kPlanning), .contact = contact};
    if (question) return step;
    question = PlanQuestion{++questions, from, to};
    step.question = question;
    return step;
  }

  /// The first contact on the way: on short straight motions from sample to sample. What is too near at the
  /// start may stay so, for the arm must find its way out.
  [[nodiscard]] std::optional<robot::Contact> contactOn(const Trajectory& motion) {
    const int samples = 1 + static_cast<int>(motion.duration().count() * fastest_rad_s / kCheckEvery_rad);
    Joints last = motion.at(motion.start()).q_rad;
    world.admitNothing();
    world.admit(last);
    for (int i = 1; i <= samples; ++i) {
      const Joints q =
          motion.at(motion.start() + toClock(motion.duration() * (static_cast<double>(i) / samples))).q_rad;
      if (i < samples && largest(q - last) < 0.5 * kCheckEvery_rad) continue;  // hardly moved since
      if (const auto contact = world.firstContact(last, q, kFinest_rad)) return contact;
      last = q;
    }
    return std::nullopt;
  }

  const RigidTransform X_FE, X_EF;
  const FollowerSettings settings;
  const double fastest_rad_s;
  robot::Kinematics kinematics;
  MotionTimer timer;
  robot::CollisionWorld world;
  Joints last_goal;
  Trajectory in_force;
  bool on_detour = false;
  std::optional<PlanQuestion> question;  // open
  std::optional<FollowOutcome> refused;  // what came of the last one, until a way is found
  std::uint64_t questions = 0;
};

Follower::Follower(const robot::ArmDescription& arm, const RigidTransform& X_FE,
                   const robot::MotionLimits& limits, robot::CollisionWorld world,
                   const FollowerSettings& settings)
    : body_(std::make_unique<Body>(arm, X_FE, limits, std::move(world), settings)) {}
Follower::~Follower() = default;

FollowStep Follower::step(const ToolGoal& goal, const MotionState& commanded, TimePoint now) {
  const auto joints = body_->jointGoal(goal, body_->seed(commanded, now));
  if (!joints) return {.outcome = FollowOutcome::kOutOfReach};
  body_->last_goal = joints->q_rad;
  if (body_->isOnDetour(now)) return {.outcome = FollowOutcome::kHeld};
  FollowStep step =
      body_->towards(*joints, body_->atHandover(commanded, now), now + toClock(body_->settings.handover));
  if (step.isNew()) body_->refused.reset();
  return step;
}

FollowStep Follower::take(const PlanAnswer& answer, const MotionState& commanded, TimePoint now) {
  if (!body_->question || answer.number != body_->question->number) return {};
  body_->question.reset();
  if (answer.refusal) {
    body_->refused = outcomeOf(answer.refusal->why);
    return {.outcome = *body_->refused, .contact = answer.refusal->contact};
  }
  const Trajectory motion = body_->timer.through(body_->atHandover(commanded, now), answer.path(),
                                                 now + toClock(body_->settings.handover));
  // The arm moved on while the way was planned, and from a moving start it bends off what was checked.
  if (const auto contact = body_->contactOn(motion))
    return {.outcome = FollowOutcome::kPlanning, .contact = contact};
  body_->refused.reset();
  body_->on_detour = true;
  body_->in_force = motion;
  return {.outcome = FollowOutcome::kPlanned, .trajectory = motion};
}

void Follower::reset() {
  body_->in_force = {};
  body_->on_detour = false;
  body_->question.reset();
  body_->refused.reset();
}

RigidTransform Follower::X_BE(const Joints& q_rad) const {
  return body_->kinematics.flange(q_rad) * body_->X_FE;
}

std::string_view id(FollowOutcome outcome) {
  switch (outcome) {
    case FollowOutcome::kDirect:
      return "direct";
    case FollowOutcome::kPlanned:
      return "planned";
    case FollowOutcome::kHeld:
      return "held";
    case FollowOutcome::kPlanning:
      return "planning";
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
