#pragma once

#include <memory>

#include "core/station/calibration_port.h"
#include "core/station/calibration_settings.h"
#include "core/station/equipment.h"

namespace mirrorarm::station {

/// Calibrating in real time. Owns the threads: acquisition, vision, control, servo and that of the long jobs.
/// Destroying it brings the robot to rest and forgets what was not accepted.
class CalibrationStation final : public CalibrationPort {
 public:
  /// `equipment.robot` may be nullptr: somebody then holds the board, and nothing is driven. Throws
  /// std::runtime_error where the limits profile is unknown.
  CalibrationStation(const Equipment& equipment, const CalibrationSettings& settings);
  ~CalibrationStation() override;
  CalibrationStation(const CalibrationStation&) = delete;
  CalibrationStation& operator=(const CalibrationStation&) = delete;

  [[nodiscard]] CalibrationAnswer request(const CalibrationCommand& command) override;
  void stop(control::StopReason reason) noexcept override;
  void resetStop() noexcept override;
  void setEnabling(control::EnablingPosition position) noexcept override;
  [[nodiscard]] CalibrationSnapshot snapshot() override;

 private:
  struct Body;
  std::unique_ptr<Body> body_;
};

}  // namespace mirrorarm::station
