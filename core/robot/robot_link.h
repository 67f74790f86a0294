#pragma once

#include <cstdint>
#include <string_view>

#include "core/common/expected.h"
#include "core/common/time.h"
#include "core/robot/compliance.h"
#include "core/robot/joints.h"

namespace mirrorarm::robot {

/// What the robot measured.
struct RobotState {
  Joints q_rad{};
  Joints v_rad_s{};
  /// By what acts on the arm from outside, as the robot's own model tells it; always empty where it has no
  /// such sensors.
  Joints external_torque_nm{};
  TimePoint measured_at{};
};

/// What the robot is to do in the next cycle.
struct RobotCommand {
  Joints q_rad{};
  Compliance compliance{};  ///< heeded as far as the robot is set to give way: see RobotLink::givesWay
};

/// Why the link does not answer or obey.
enum class LinkFault : std::uint8_t {
  kNone,
  kNoAnswer,    ///< no message, or none that can be believed
  kNotReady,    ///< it answers, but does not take commands (now)
  kDriveFault,  ///< its drives, or what it was told, are at fault
  kPoorLine,    ///< messages come late, doubled or not at all too often for it to be moved
};
/// "none", "no_answer", "not_ready", "drive_fault", "poor_line".
[[nodiscard]] std::string_view id(LinkFault fault);

/// A robot arm: real, simulated or replayed. Used by the servo thread only; no call allocates or waits longer
/// than a cycle.
class RobotLink {
 public:
  virtual ~RobotLink() = default;

  /// Newest measured state; a fault when none came since the cycle before.
  [[nodiscard]] virtual Expected<RobotState, LinkFault> read() noexcept = 0;
  /// What to do in the next cycle.
  [[nodiscard]] virtual Expected<void, LinkFault> command(const RobotCommand& command) noexcept = 0;
  /// Brakes to rest within the robot's own limits and gives up control of it: the way out of every failure
  /// (stop category 1, where the robot switches its drives off by itself afterwards). May be called again and
  /// again.
  virtual void halt() noexcept = 0;
  /// Cycle time that the link expects.
  [[nodiscard]] virtual Seconds period() const noexcept = 0;
  /// Whether the robot's own messages set the pace; else the host keeps the beat.
  [[nodiscard]] virtual bool setsThePace() const noexcept { return false; }
  /// Waits for the robot's next message, at most so long. Only where it sets the pace.
  virtual void awaitCycle(Seconds /*longest*/) noexcept {}
  /// Whether it may be moved now: a robot that only monitors must be commanded where it rests until it does.
  [[nodiscard]] virtual bool takesCommands() const noexcept { return true; }
  /// How the robot is set to give way to a force. Does not change while it moves.
  [[nodiscard]] virtual GivesWay givesWay() const noexcept { return GivesWay::kNot; }
};

/// The way out of a loop that drives `link`: halts it and, where the robot's messages set the pace, answers
/// them until it has come to rest, at most so long. One that is braked by these answers and does not get them
/// is left to its own watchdogs.
void haltToRest(RobotLink& link, Seconds longest = Seconds(1.0)) noexcept;

}  // namespace mirrorarm::robot
