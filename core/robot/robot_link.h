#pragma once

#include <cstdint>
#include <string_view>

#include "core/common/expected.h"
#include "core/common/time.h"
#include "core/robot/joints.h"

namespace mirrorarm::robot {

/// What the robot measured.
struct RobotState {
  Joints q_rad;
  Joints v_rad_s;
  TimePoint measured_at{};
};

/// Why the link does not answer or obey.
enum class LinkFault : std::uint8_t { kNone, kNoAnswer, kNotReady, kDriveFault };
/// "none", "no_answer", "not_ready", "drive_fault".
[[nodiscard]] std::string_view id(LinkFault fault);

/// A robot arm: real, simulated or replayed. Used by the servo thread only; no call allocates or waits longer
/// than a cycle.
class RobotLink {
 public:
  virtual ~RobotLink() = default;

  /// Newest measured state; a fault when none came since the cycle before.
  [[nodiscard]] virtual Expected<RobotState, LinkFault> read() noexcept = 0;
  /// Joint positions for the next cycle [rad].
  [[nodiscard]] virtual Expected<void, LinkFault> command(const Joints& q_rad) noexcept = 0;
  /// Brakes to rest within the robot's own limits. The way out of every failure; may be called again and
  /// again.
  virtual void halt() noexcept = 0;
  /// Cycle time that the link expects.
  [[nodiscard]] virtual Seconds period() const noexcept = 0;
};

}  // namespace mirrorarm::robot
