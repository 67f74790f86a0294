#pragma once

#include <QString>

#include "core/calibration/drift_check.h"
#include "core/station/calibration_command.h"

namespace mirrorarm::ui {

// The words that engineers read in the wizards. Translated; whole phrases, no full stop.

[[nodiscard]] QString words(station::CalibrationJob job);
[[nodiscard]] QString words(station::CalibrationAction action);
[[nodiscard]] QString words(station::CalibrationAnswer answer);
[[nodiscard]] QString words(calibration::BoardKind kind);
[[nodiscard]] QString words(calibration::DriftVerdict verdict);
[[nodiscard]] QString words(camera::LensModel model);

/// What the job is good for, one sentence.
[[nodiscard]] QString purpose(station::CalibrationJob job);

}  // namespace mirrorarm::ui
