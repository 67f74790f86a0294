#pragma once

#include <memory>

#include "core/common/time_source.h"
#include "core/station/calibration_port.h"
#include "core/station/calibration_settings.h"
#include "core/station/equipment.h"

namespace mirrorarm::station {

/// The same stages without threads, run in the order of their due times on a clock that this class sets; long
/// jobs are done at once. As fast as the machine computes, and the same for the same seed: for tests and
/// experiments. Its equipment must be simulated and answer without waiting. One thread.
class LockstepCalibrationStation final : public CalibrationPort {
 public:
  /// `time` is the clock of the simulated equipment and outlives the station.
  LockstepCalibrationStation(const Equipment& equipment, const CalibrationSettings& settings,
                             ManualTime& time);
  ~LockstepCalibrationStation() override;

  /// Runs everything that is due until `time`, which becomes the clock's time.
  void advanceTo(TimePoint time);

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
