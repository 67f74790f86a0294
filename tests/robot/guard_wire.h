#pragma once

#include <algorithm>
#include <array>

#include "core/robot/kinematics.h"
#include "core/robot/motion_limits.h"

namespace mirrorarm::robot::testing {

/// The worst that went over the wire, as shares of the limits; of the ranges the excess [rad].
struct WireWorst {
  double position_rad = -1.0, speed = 0.0, acceleration = 0.0, jerk = 0.0;
  double tool_speed = 0.0, tool_acceleration = 0.0;
};

/// Looks at the positions alone, as a robot's controller does: everything else is their differences.
class WireWatch {
 public:
  WireWatch(const ArmDescription& arm, const MotionLimits& limits, double period_s)
      : kinematics_(arm), limits_(limits), period_s_(period_s) {}

  /// The arm rests at `q`.
  void restart(const Joints& q) {
    q_.fill(q);
    p_.fill(kinematics_.flange(q).translation());
  }

  /// Of this cycle alone.
  WireWorst look(const Joints& q) {
    std::rotate(q_.begin(), q_.begin() + 1, q_.end());
    std::rotate(p_.begin(), p_.begin() + 1, p_.end());
    q_.back() = q;
    p_.back() = kinematics_.flange(q).translation();
    const auto share = [](const Joints& of, const Joints& limit) {
      return (of.array().abs() / limit.array()).maxCoeff();
    };
    const double T = period_s_;
    const Joints a = (q_[3] - 2.0 * q_[2] + q_[1]) / (T * T);
    const Joints a_before = (q_[2] - 2.0 * q_[1] + q_[0]) / (T * T);
    return {std::max((q - limits_.upper_rad).maxCoeff(), (limits_.lower_rad - q).maxCoeff()),
            share((q_[3] - q_[2]) / T, limits_.max_speed_rad_s),
            share(a, limits_.max_acceleration_rad_s2),
            share((a - a_before) / T, limits_.max_jerk_rad_s3),
            toolSpeed() / limits_.max_tool_speed_m_s,
            (p_[3] - 2.0 * p_[2] + p_[1]).norm() / (T * T) / limits_.max_tool_acceleration_m_s2};
  }

  [[nodiscard]] double toolSpeed() const { return (p_[3] - p_[2]).norm() / period_s_; }

 private:
  Kinematics kinematics_;
  const MotionLimits limits_;
  double period_s_;
  std::array<Joints, 4> q_;
  std::array<Eigen::Vector3d, 4> p_;
};

inline void worsen(WireWorst& worst, const WireWorst& now) {
  worst.position_rad = std::max(worst.position_rad, now.position_rad);
  worst.speed = std::max(worst.speed, now.speed);
  worst.acceleration = std::max(worst.acceleration, now.acceleration);
  worst.jerk = std::max(worst.jerk, now.jerk);
  worst.tool_speed = std::max(worst.tool_speed, now.tool_speed);
  worst.tool_acceleration = std::max(worst.tool_acceleration, now.tool_acceleration);
}

}  // namespace mirrorarm::robot::testing
