#include "core/simulation/joint_drives.h"

#include <algorithm>
#include <cassert>

namespace mirrorarm::simulation {
namespace {

constexpr double kStiffness_hz = 150.0;           // angular: the lag is 2 / this
constexpr double kMaxAcceleration_rad_s2 = 20.0;  // what the motors can
constexpr double kBraking_rad_s2 = 6.0;

}  // namespace

JointDrives::JointDrives(const robot::ArmDescription& arm, const robot::Joints& start)
    : lower_(arm.jointCount()), upper_(arm.jointCount()), max_speed_(arm.jointCount()), q_(start) {
  assert(start.size() == arm.jointCount());
  v_ = robot::Joints::Zero(start.size());
  for (int i = 0; i < arm.jointCount(); ++i) {
    const auto& joint = arm.joints[static_cast<std::size_t>(i)];
    lower_[i] = joint.lower_rad;
    upper_[i] = joint.upper_rad;
    max_speed_[i] = joint.max_speed_rad_s;
  }
  commands_.fill({TimePoint{}, start});
}

void JointDrives::command(TimePoint time, const robot::Joints& q_rad) noexcept {
  commands_[next_] = {time, q_rad};
  next_ = (next_ + 1) % commands_.size();
  count_ = std::min(count_ + 1, commands_.size());
}

void JointDrives::halt() noexcept { count_ = 0; }

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

void JointDrives::advance(TimePoint to, Seconds step) noexcept {
  const double dt = step.count();
  robot::Joints reference(q_.size());
  const bool following = referenceAt(to - toClock(kDelay), reference);
  for (Eigen::Index i = 0; i < q_.size(); ++i) {
    if (following) {
      const double wanted = kStiffness_hz * (kStiffness_hz * (reference[i] - q_[i]) - 2.0 * v_[i]);
      v_[i] += dt * std::clamp(wanted, -kMaxAcceleration_rad_s2, kMaxAcceleration_rad_s2);
    } else {
      v_[i] -= std::clamp(v_[i], -dt * kBraking_rad_s2, dt * kBraking_rad_s2);
    }
    v_[i] = std::clamp(v_[i], -max_speed_[i], max_speed_[i]);
    const double next = q_[i] + dt * v_[i];
    q_[i] = std::clamp(next, lower_[i], upper_[i]);
    if (q_[i] != next) v_[i] = 0.0;
  }
}

}  // namespace mirrorarm::simulation
