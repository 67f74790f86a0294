#pragma once

#include <filesystem>
#include <string>

#include "core/calibration/drift_check.h"
#include "core/common/file_error.h"

namespace mirrorarm::calibration {

/// A check of the calibrations in force, as it is kept.
struct DriftRecord {
  std::string date;  ///< ISO 8601
  DriftFindings findings;
};

/// Reads `drift.yaml` (format mirrorarm/drift/1). Refused with the line and key: what is unknown, missing or
/// out of range.
[[nodiscard]] FromFile<DriftRecord> readDriftRecord(const std::filesystem::path& file);

/// Writes it, whole or not at all.
[[nodiscard]] Expected<void, std::string> writeDriftRecord(const std::filesystem::path& file,
                                                           const DriftRecord& record);

}  // namespace mirrorarm::calibration
