#pragma once

#include <string>
#include <vector>

namespace mirrorarm::calibration {

/// What the operator can mend; the more telling further down.
enum class CalibrationError {
  kTooFewViews,
  kNotSolved,
  kMisfit,
  kViewsTooAlike,
  kImageSize,
  kSidesSwapped,
  kPairsOutOfOrder,
};

/// Why there is no calibration, and which views are to blame where that is known.
struct CalibrationRefusal {
  CalibrationError error = CalibrationError::kNotSolved;
  std::vector<std::string> views;
};

/// One line for an engineer: what is wrong, the remedy and the views.
[[nodiscard]] std::string reason(const CalibrationRefusal& refusal);

}  // namespace mirrorarm::calibration
