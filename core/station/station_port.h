#pragma once

#include "core/control/enabling_switch.h"
#include "core/control/stop_reason.h"
#include "core/station/command.h"
#include "core/station/snapshot.h"

namespace mirrorarm::station {

/// What an operator, a screen or a script sees of a station: commands in, snapshots out.
class StationPort {
 public:
  virtual ~StationPort() = default;

  /// kQueueFull or kAccepted at once; whether the phase allows it is said in the snapshot's `last_answer`.
  /// Any thread.
  [[nodiscard]] virtual Answer request(const Command& command) = 0;

  /// How much the robot is to help from now on, in any phase; answered like a command. Any thread.
  [[nodiscard]] virtual Answer changeHelp(const control::Help& help) = 0;

  /// Brings the robot to rest, past every queue. Any thread, any time, as often as wanted.
  virtual void stop(control::StopReason reason) noexcept = 0;
  /// Asks to free a latched stop; the session stays paused. The snapshot's `servo.reset` says why it is
  /// refused. Any thread.
  virtual void resetStop() noexcept = 0;
  /// Where the operator holds the enabling device: to be said again and again while he holds it, for silence
  /// counts as released. Any thread.
  virtual void setEnabling(control::EnablingPosition position) noexcept = 0;

  /// The newest of everything. One thread, the screen's.
  [[nodiscard]] virtual Snapshot snapshot() = 0;
};

}  // namespace mirrorarm::station
