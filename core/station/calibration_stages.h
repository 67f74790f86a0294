#pragma once

#include <memory>

#include "core/control/servo_loop.h"
#include "core/station/board_stage.h"
#include "core/station/calibration_control.h"
#include "core/station/calibration_settings.h"
#include "core/station/equipment.h"

namespace mirrorarm::station {

/// The stages of a calibration, joined; what runs them is CalibrationStation or LockstepCalibrationStation.
class CalibrationStages {
 public:
  /// Throws std::runtime_error where the limits profile is unknown.
  CalibrationStages(const Equipment& equipment, const CalibrationSettings& settings, JobRunner& runner);

  std::unique_ptr<control::ServoLoop> servo;  ///< nullptr without a robot
  BoardStage boards;
  CalibrationControl control;

  /// Any thread.
  void stop(control::StopReason reason) noexcept;
  void resetStop() noexcept;
  void setEnabling(control::EnablingPosition position) noexcept;

  /// The newest of everything; what has not changed since the last call is given again. Screen's thread only.
  [[nodiscard]] CalibrationSnapshot snapshot();

 private:
  CalibrationStages(const Equipment& equipment, const CalibrationSettings& settings,
                    std::shared_ptr<const PlannedArm> arm, JobRunner& runner);
  std::shared_ptr<const CalibrationSnapshot> snapshot_;
};

}  // namespace mirrorarm::station
