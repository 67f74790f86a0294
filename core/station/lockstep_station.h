#pragma once

#include <memory>

#include "core/common/time_source.h"
#include "core/station/equipment.h"
#include "core/station/station_port.h"
#include "core/station/station_settings.h"

namespace mirrorarm::station {

/// The same stages without threads, run in the order of their due times on a clock that this class sets: as
/// fast as the machine computes, and the same for the same seed. For tests, experiments and `session --fast`;
/// its equipment must be simulated and answer without waiting. One thread.
class LockstepStation final : public StationPort {
 public:
  /// `time` is the clock of the simulated equipment and outlives the station.
  LockstepStation(const Equipment& equipment, const StationSettings& settings, ManualTime& time);
  ~LockstepStation() override;

  /// Runs everything that is due until `time`, which becomes the clock's time.
  void advanceTo(TimePoint time);

  [[nodiscard]] Answer request(const Command& command) override;
  [[nodiscard]] Answer changeHelp(const control::Help& help) override;
  void stop(control::StopReason reason) noexcept override;
  void resetStop() noexcept override;
  void setEnabling(control::EnablingPosition position) noexcept override;
  [[nodiscard]] Snapshot snapshot() override;

 private:
  struct Body;
  std::unique_ptr<Body> body_;
};

}  // namespace mirrorarm::station
