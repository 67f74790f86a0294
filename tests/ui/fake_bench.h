#pragma once

#include <memory>

#include "core/station/station_port.h"
#include "ui/model/workplace.h"

namespace mirrorarm::ui::test {

/// The workplace of the bench: LBR 4+, pinhole rig, camera and sling on the flange.
[[nodiscard]] Workplace benchWorkplace();

/// A station without threads that shows what the test sets up: the bench at rest, ten markers before the
/// cameras. It obeys therapy::after, so that buttons lead where they should.
class FakeStation final : public station::StationPort {
 public:
  explicit FakeStation(const Workplace& workplace);

  [[nodiscard]] station::Answer request(const station::Command& command) override;
  [[nodiscard]] station::Answer changeHelp(const control::Help& help) override;
  void stop(control::StopReason reason) noexcept override;
  void resetStop() noexcept override;
  void setEnabling(control::EnablingPosition position) noexcept override;
  [[nodiscard]] station::Snapshot snapshot() override;

  /// Goes on to `phase`, with a target once it is taught.
  void enter(therapy::Phase phase);
  /// Reflections besides the markers, refused each for a reason; marker 3 half covered; a disc with two
  /// possible partners; the right image too bright.
  void clutter();
  station::Snapshot shown;  ///< what snapshot() gives, stamped with the time of the call
  station::Command last_command;
  int stops = 0;
  int resets = 0;
  int requests = 0;
  station::Answer answer = station::Answer::kAccepted;  ///< that request() gives at once
  bool frozen = false;                                  ///< times are left as they are

 private:
  void stamp();
  const camera::StereoRig rig_;
  std::shared_ptr<station::TrackedFrame> frame_;
  std::shared_ptr<const tracking::Target> target_;
};

}  // namespace mirrorarm::ui::test
