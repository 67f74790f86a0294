#pragma once

#include <optional>

#include <QString>

#include "core/station/calibration_snapshot.h"
#include "ui/model/light.h"

namespace mirrorarm::ui {

/// What to do now, in words, and the one thing to press.
struct CalibrationGuide {
  QString title;
  QString instruction;  ///< one to three sentences
  std::optional<station::CalibrationAction> primary;
};

/// `chosen`: the job that would begin; `result`: the light of the result, in kSolved.
[[nodiscard]] CalibrationGuide guideOf(const station::CalibrationSnapshot& snapshot,
                                       station::CalibrationJob chosen, Light result);

}  // namespace mirrorarm::ui
