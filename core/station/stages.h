#pragma once

#include "core/control/servo_loop.h"
#include "core/station/control_stage.h"
#include "core/station/equipment.h"
#include "core/station/recorder_stage.h"
#include "core/station/station_settings.h"
#include "core/station/tracking_stage.h"

namespace mirrorarm::station {

/// Cadence of the stages that no device drives.
inline constexpr Seconds kControlPeriod{0.010};
inline constexpr Seconds kRecorderPeriod{0.250};

/// The stages, joined; what runs them is Station or LockstepStation.
class Stages {
 public:
  /// Throws std::runtime_error where the store cannot be opened or the limits profile is unknown.
  Stages(const Equipment& equipment, const StationSettings& settings);

  const robot::MotionLimits limits;
  control::ServoLoop servo;
  control::PlanningDesk desk;
  TrackingStage tracking;
  RecorderStage recorder;
  ControlStage control;

  /// The newest of everything; what has not changed since the last call is given again. Screen's thread only.
  [[nodiscard]] const Snapshot& snapshot();

 private:
  Snapshot snapshot_;
};

}  // namespace mirrorarm::station
