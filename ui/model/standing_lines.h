#pragma once

#include <array>

#include <QString>

#include "core/calibration/validity.h"
#include "core/station/calibration_command.h"
#include "ui/model/light.h"

namespace mirrorarm::ui {

/// How one of the calibrations in force stands, in a few words.
struct StandingLine {
  Light light = Light::kOff;  ///< good: valid; waiting: doubtful; bad: it does not hold; off: there is none
  QString text;               ///< "in force, 3 days old"
  bool operator==(const StandingLine&) const = default;
};

/// By station::CalibrationJob.
using StandingLines = std::array<StandingLine, station::kCalibrationJobCount>;
[[nodiscard]] StandingLines standingLines(const calibration::Validity& validity);
[[nodiscard]] StandingLine standingLine(const calibration::CalibrationStatus& status);

/// The kind of record that a job gives.
[[nodiscard]] calibration::CalibrationKind kindOf(station::CalibrationJob job);

}  // namespace mirrorarm::ui
