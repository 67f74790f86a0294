#pragma once

#include <filesystem>
#include <string>

#include "core/common/file_error.h"
#include "core/tracking/arm_calibration.h"

namespace mirrorarm::tracking {

/// An arm's bones with how they were found.
struct ArmRecord {
  ArmModel model;
  std::string date;  ///< ISO 8601; may be empty
  ArmCalibrationQuality quality;
};

/// Reads `arm.yaml` (format mirrorarm/arm/1). Refused with line and key: what is unknown, missing, not finite
/// or no rotation, a side that is neither left nor right, a target named twice.
[[nodiscard]] FromFile<ArmRecord> readArm(const std::filesystem::path& file);

/// Writes it, whole or not at all.
[[nodiscard]] Expected<void, std::string> writeArm(const std::filesystem::path& file, const ArmRecord& arm);

}  // namespace mirrorarm::tracking
