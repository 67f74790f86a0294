#pragma once

#include <array>
#include <cstddef>

#include "core/common/time.h"
#include "core/robot/arm_description.h"
#include "core/robot/joints.h"

namespace mirrorarm::simulation {

/// The drives of an arm: they follow the commands of 10 ms ago (which they interpolate, as robot controllers
/// do), stiffly as a critically damped second-order lag of 13 ms, or softly as springs with their inertia,
/// which what acts from outside stretches. Always within the joints' ranges, speeds and torques; on halt they
/// brake evenly and hold. One thread; does not allocate.
class JointDrives {
 public:
  static constexpr Seconds kCycle{0.001};
  static constexpr Seconds kDelay{0.010};

  JointDrives(const robot::ArmDescription& arm, const robot::Joints& start);

  void command(TimePoint time, const robot::Joints& q_rad) noexcept;
  void halt() noexcept;
  /// From now on the drives are springs of this stiffness and damping; until then they are stiff.
  void soften(const robot::Joints& stiffness_nm_rad, double damping) noexcept;
  /// Moves on by `step`, at most a few milliseconds. `external_torque_nm` moves soft drives only; empty:
  /// nothing acts from outside.
  void advance(TimePoint to, Seconds step, const robot::Joints& external_torque_nm = {}) noexcept;

  [[nodiscard]] const robot::Joints& q() const noexcept { return q_; }
  [[nodiscard]] const robot::Joints& v() const noexcept { return v_; }

 private:
  struct Command {
    TimePoint time{};
    robot::Joints q;
  };
  [[nodiscard]] const Command& recent(std::size_t age) const noexcept {
    return commands_[(next_ + commands_.size() - 1 - age) % commands_.size()];
  }
  [[nodiscard]] bool referenceAt(TimePoint time, robot::Joints& reference) const noexcept;
  [[nodiscard]] double springAcceleration(Eigen::Index joint, double reference, double reference_speed,
                                          double external_torque_nm) const noexcept;
  void move(Eigen::Index joint, double acceleration, double dt) noexcept;

  robot::Joints lower_, upper_, max_speed_, max_torque_;
  robot::Joints stiffness_;  ///< empty while the drives are stiff
  double damping_ = 0.7;
  robot::Joints reference_;  ///< of the last step; empty while not following
  robot::Joints q_, v_;
  std::array<Command, 32> commands_;
  std::size_t next_ = 0;
  std::size_t count_ = 0;  ///< commands since the last halt, at most as many as are kept
};

}  // namespace mirrorarm::simulation
