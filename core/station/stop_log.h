#pragma once

#include <optional>

#include "core/control/servo_state.h"

namespace mirrorarm::station {

/// What one servo cycle tells of stops.
struct StopNews {
  bool begun = false;
  bool graver = false;   ///< the stop went over to category 1
  bool ended = false;    ///< it was reset
  bool box_due = false;  ///< the black box holds the whole stop now: keep it
  control::StopReason reason = control::StopReason::kNone;  ///< of the stop that this is about
};

/// Follows the stops through the servo cycles, so that each leaves one black box: taken when the robot has
/// come to rest, so that it shows how it did, or a second after the stop where it does not. Control thread
/// only.
class StopLog {
 public:
  /// Every cycle, in their order.
  [[nodiscard]] StopNews update(const control::ServoState& cycle) noexcept;

  /// The reason of a stop whose black box is not due yet: to be kept before the program ends.
  [[nodiscard]] std::optional<control::StopReason> unkept() const noexcept {
    return box_waits_ ? std::optional(reason_) : std::nullopt;
  }

 private:
  control::StopReason reason_ = control::StopReason::kNone;
  control::StopCategory category_ = control::StopCategory::kNone;
  TimePoint begun_at_{};
  bool box_waits_ = false;
};

}  // namespace mirrorarm::station
