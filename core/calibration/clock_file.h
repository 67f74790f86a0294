#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "core/calibration/clock_offset.h"
#include "core/common/file_error.h"

namespace mirrorarm::calibration {

/// A clock offset as it is kept; what is unknown is empty or 0.
struct ClockRecord {
  double offset_s = 0.0;  ///< add it to a camera's time to have the robot's time of the same moment
  double sigma_s = 0.0;   ///< its standard deviation
  std::string date;       ///< ISO 8601
  std::string note;       ///< where it came from: a recording, the files of both streams
  double correlation = 0.0;
  std::size_t poses = 0;  ///< camera poses compared
  double median_m = 0.0;
  double median_rad = 0.0;
};

/// What to keep of a solved offset.
[[nodiscard]] ClockRecord recordOf(const ClockOffset& offset, std::string date, std::string note);

/// Reads `clock.yaml` (format mirrorarm/clock/1). Refused with the line and key: what is unknown, missing or
/// out of range.
[[nodiscard]] FromFile<ClockRecord> readClockRecord(const std::filesystem::path& file);

/// Writes it, whole or not at all.
[[nodiscard]] Expected<void, std::string> writeClockRecord(const std::filesystem::path& file,
                                                           const ClockRecord& record);

}  // namespace mirrorarm::calibration
