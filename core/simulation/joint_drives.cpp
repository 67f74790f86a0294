#include "core/simulation/joint_drives.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace mirrorarm::simulation {
namespace {

constexpr double kStiffness_hz = 150.0;           // angular: the lag is 2 / this
constexpr double kMaxAcceleration_rad_s2 = 20.0;  // what the motors can
constexpr double kBraking_rad_s2 = 6.0;

/// What a joint of a light arm moves, in working postures: the first ones the whole arm, the last the hand.
double inertiaOf(Eigen::Index joint) { return joint < 2 ? 1.5 : joint < 4 ? 0.5 : 0.1; }

}  // namespace

JointDrives::JointDrives(const robot::ArmDescription& arm, const robot::Joints& start)
    : lower_(arm.jointCount()),
      upper_(arm.jointCount()),
      max_speed_(arm.jointCount()),
      max_torque_(arm.jointCount()),
      q_(start) {
  assert(start.size() == arm.jointCount());
  v_ = robot::Joints::Zero(start.size());
  for (int i = 0; i < arm.jointCount(); ++i) {
    const auto& joint = arm.joints[static_cast<std::size_t>(i)];
    lower_[i] = joint.lower_rad;
    upper_[i] = joint.upper_rad;
    max_speed_[i] = joint.max_speed_rad_s;
    max_torque_[i] = joint.max_torque_nm;
  }
  commands_.fill({TimePoint{}, start});
}

void JointDrives::command(TimePoint time, const robot::Joints& q_rad) noexcept {
  commands_[next_] = {time, q_rad};
  next_ = (next_ + 1) % commands_.size();
  count_ = std::min(count_ + 1, commands_.size());
}

void JointDrives::halt() noexcept { count_ = 0; }

void JointDrives::soften(const robot::Joints& stiffness_nm_rad, double damping) noexcept {
  assert(stiffness_nm_rad.size() == q_.size());
  stiffness_ = stiffness_nm_rad;
  damping_ = damping;
}

bool JointDrives::referenceAt(TimePoint time, robot::Joints& reference) const noexcept {
  for (std::size_t age = 0; age < count_; ++age) {
    const Command& before = recent(age);
    if (before.time > time) continue;
    reference = before.q;
    if (age > 0) {
      const Command& after = recent(age - 1);
      const double share = secondsBetween(before.time, time) / secondsBetween(before.time, after.time);
      reference += share * (after.q - before.q);
    }
    return true;
  }
  return false;
}

double JointDrives::springAcceleration(Eigen::Index joint, double reference, double reference_speed,
                                       double external_torque_nm) const noexcept {
  const double inertia = inertiaOf(joint);
  const double stiffness = stiffness_[joint];
  const double spring = stiffness * (reference - q_[joint]);
  const double damper = 2.0 * damping_ * std::sqrt(stiffness * inertia) * (reference_speed - v_[joint]);
  const double motor = std::clamp(spring + damper, -max_torque_[joint], max_torque_[joint]);
  return (motor + external_torque_nm) / inertia;
}

void JointDrives::move(Eigen::Index joint, double acceleration, double dt) noexcept {
  v_[joint] = std::clamp(v_[joint] + dt * acceleration, -max_speed_[joint], max_speed_[joint]);
  const double next = q_[joint] + dt * v_[joint];
  q_[joint] = std::clamp(next, lower_[joint], upper_[joint]);
  if (q_[joint] != next) v_[joint] = 0.0;
}

void JointDrives::advance(TimePoint to, Seconds step, const robot::Joints& external_torque_nm) noexcept {
  const double dt = step.count();
  robot::Joints reference(q_.size());
  const bool following = referenceAt(to - toClock(kDelay), reference);
  const bool was_following = reference_.size() == q_.size();
  for (Eigen::Index i = 0; i < q_.size(); ++i) {
    if (!following) {
      move(i, std::clamp(-v_[i] / dt, -kBraking_rad_s2, kBraking_rad_s2), dt);
    } else if (stiffness_.size() == 0) {
      const double wanted = kStiffness_hz * (kStiffness_hz * (reference[i] - q_[i]) - 2.0 * v_[i]);
      move(i, std::clamp(wanted, -kMaxAcceleration_rad_s2, kMaxAcceleration_rad_s2), dt);
    } else {
      const double speed = was_following ? (reference[i] - reference_[i]) / dt : 0.0;
      const double external = external_torque_nm.size() == q_.size() ? external_torque_nm[i] : 0.0;
      move(i, springAcceleration(i, reference[i], speed, external), dt);
    }
  }
  reference_ = following ? reference : robot::Joints();
}

}  // namespace mirrorarm::simulation
