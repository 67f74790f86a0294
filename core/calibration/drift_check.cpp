#include "core/calibration/drift_check.h"

namespace mirrorarm::calibration {

std::string_view id(DriftVerdict verdict) {
  switch (verdict) {
    case DriftVerdict::kHolds:
      return "holds";
    case DriftVerdict::kDoubtful:
      return "doubtful";
    case DriftVerdict::kFailed:
      break;
  }
  return "failed";
}

std::optional<DriftVerdict> driftVerdictOf(std::string_view text) {
  for (const auto verdict : {DriftVerdict::kHolds, DriftVerdict::kDoubtful, DriftVerdict::kFailed})
    if (text == id(verdict)) return verdict;
  return std::nullopt;
}

}  // namespace mirrorarm::calibration
