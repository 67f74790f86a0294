#include "core/tracking/tracked_target.h"

namespace mirrorarm::tracking {

std::string_view id(TrackStatus status) {
  switch (status) {
    case TrackStatus::kTracked:
      return "tracked";
    case TrackStatus::kPredicted:
      return "predicted";
    case TrackStatus::kLost:
      return "lost";
  }
  return "lost";
}

std::string_view id(LostReason reason) {
  switch (reason) {
    case LostReason::kNone:
      return "none";
    case LostReason::kNoPoints:
      return "no_points";
    case LostReason::kTooFewMarkers:
      return "too_few_markers";
    case LostReason::kBadFit:
      return "bad_fit";
    case LostReason::kNotConverged:
      return "not_converged";
  }
  return "none";
}

}  // namespace mirrorarm::tracking
