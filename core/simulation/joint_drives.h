#pragma once

#include <array>
#include <cstddef>

#include "core/common/time.h"
#include "core/robot/arm_description.h"
#include "core/robot/joints.h"

namespace mirrorarm::simulation {

/// The position drives of an arm: they follow the commands of 10 ms ago (which they interpolate, as robot
/// controllers do) as a critically damped second-order lag of 13 ms, within the joints' ranges and speeds; on
/// halt they brake evenly. One thread; does not allocate.
class JointDrives {
 public:
  static constexpr Seconds kCycle{0.001};
  static constexpr Seconds kDelay{0.010};

  JointDrives(const robot::ArmDescription& arm, const robot::Joints& start);

  void command(TimePoint time, const robot::Joints& q_rad) noexcept;
  void halt() noexcept;
  /// Moves on by `step`, at most a few milliseconds.
  void advance(TimePoint to, Seconds step) noexcept;

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

  robot::Joints lower_, upper_, max_speed_;
  robot::Joints q_, v_;
  std::array<Command, 32> commands_;
  std::size_t next_ = 0;
  std::size_t count_ = 0;  ///< commands since the last halt, at most as many as are kept
};

}  // namespace mirrorarm::simulation
