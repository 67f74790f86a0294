#pragma once

#include "core/control/enabling_switch.h"
#include "core/control/stop_reason.h"
#include "core/station/calibration_command.h"
#include "core/station/calibration_snapshot.h"

namespace mirrorarm::station {

/// What a wizard sees of a calibration: commands in, snapshots out.
class CalibrationPort {
 public:
  virtual ~CalibrationPort() = default;

  /// kQueueFull or kAccepted at once; what became of it is said in the snapshot's `last_answer`. Any thread.
  [[nodiscard]] virtual CalibrationAnswer request(const CalibrationCommand& command) = 0;

  /// Brings the robot to rest, past every queue. Any thread, any time, as often as wanted.
  virtual void stop(control::StopReason reason) noexcept = 0;
  /// Frees a latched stop; the robot stays at rest until it is to drive again. Any thread.
  virtual void resetStop() noexcept = 0;
  /// Where the operator holds the enabling device: to be said again and again while he holds it, for silence
  /// counts as released. Any thread.
  virtual void setEnabling(control::EnablingPosition position) noexcept = 0;

  /// The newest of everything. One thread, the screen's.
  [[nodiscard]] virtual CalibrationSnapshot snapshot() = 0;
};

}  // namespace mirrorarm::station
