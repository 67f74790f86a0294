#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/calibration/calibration_folder.h"

namespace mirrorarm::calibration {

/// How one of them stands.
enum class Standing : std::uint8_t {
  kValid,
  kMissing,   ///< none in force
  kUndated,   ///< without a date that can be read, or one in the future: its age is unknown
  kExpired,   ///< older than its limit
  kDoubtful,  ///< a drift check that asks for a new calibration soon; a session may run
  kFailed,    ///< a drift check that says the calibration does not hold
};
/// "valid", "missing", "undated", "expired", "doubtful", "failed".
[[nodiscard]] std::string_view id(Standing standing);

/// How old a calibration may be. A drift check is for one working day.
struct ValidityLimits {
  std::chrono::hours rig{90 * 24};
  std::chrono::hours hand_eye{90 * 24};
  std::chrono::hours clock{90 * 24};
  std::chrono::hours drift{16};
};

struct CalibrationStatus {
  Standing standing = Standing::kMissing;
  std::string date;             ///< ISO 8601; empty where there is none
  std::chrono::minutes age{0};  ///< 0 where it is unknown
};

/// All of them at one time.
struct Validity {
  std::array<CalibrationStatus, kCalibrationKindCount> status;

  [[nodiscard]] const CalibrationStatus& of(CalibrationKind kind) const {
    return status[static_cast<std::size_t>(kind)];
  }
  /// Rig and hand-eye are valid and the drift check of the day has not failed. A clock offset may be missing:
  /// cameras that stamp by the robot's clock need none; one that is there must be valid.
  [[nodiscard]] bool allowsSession() const;
};

[[nodiscard]] Validity validityOf(const InForce& in_force, std::chrono::system_clock::time_point now,
                                  const ValidityLimits& limits = {});

}  // namespace mirrorarm::calibration
