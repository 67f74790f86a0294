#include "core/station/command.h"
#include "core/station/snapshot.h"

namespace mirrorarm::station {

std::string_view id(Answer answer) {
  switch (answer) {
    case Answer::kAccepted:
      return "accepted";
    case Answer::kNotNow:
      return "not_now";
    case Answer::kStopLatched:
      return "stop_latched";
    case Answer::kNotEnabled:
      return "not_enabled";
    case Answer::kTargetUnseen:
      return "target_unseen";
    case Answer::kNotCalibrated:
      return "not_calibrated";
    case Answer::kTooFewMarkers:
      return "too_few_markers";
    case Answer::kHoldsStiffly:
      return "holds_stiffly";
    case Answer::kOutOfRange:
      return "out_of_range";
    case Answer::kQueueFull:
      return "queue_full";
  }
  return "unknown";
}

std::string_view id(Recording recording) {
  switch (recording) {
    case Recording::kIdle:
      return "idle";
    case Recording::kWriting:
      return "writing";
    case Recording::kComplete:
      return "complete";
    case Recording::kFailed:
      return "failed";
  }
  return "unknown";
}

}  // namespace mirrorarm::station
