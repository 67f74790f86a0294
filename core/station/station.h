#pragma once

#include <memory>

#include "core/station/equipment.h"
#include "core/station/station_port.h"
#include "core/station/station_settings.h"

namespace mirrorarm::station {

/// The workstation in real time. Owns the threads and joins the rooms: acquisition, tracking, control, servo
/// and recorder thread. Destroying it brings the robot to rest and closes the record.
class Station final : public StationPort {
 public:
  /// Throws std::runtime_error where the store cannot be opened or the limits profile is unknown.
  Station(const Equipment& equipment, const StationSettings& settings);
  ~Station() override;
  Station(const Station&) = delete;
  Station& operator=(const Station&) = delete;

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
