#pragma once

#include <optional>
#include <string_view>

#include "core/therapy/movement_mapping.h"
#include "core/therapy/session_phase.h"

namespace mirrorarm::station {

/// One wish of the operator. Stopping is not among them: Station::stop() goes past every queue.
struct Command {
  therapy::Action action = therapy::Action::kTeach;
  therapy::Mapping mapping = therapy::Mapping::kFollow;  ///< for kAlign
};

/// What became of a wish.
enum class Answer {
  kAccepted,
  kNotNow,         ///< not allowed in this phase
  kStopLatched,    ///< reset the stop first
  kNotEnabled,     ///< starting needs the enabling device to be held
  kTargetUnseen,   ///< aligning and starting need the target in view
  kNotCalibrated,  ///< aligning and starting need calibrations that are in force and hold
  kTooFewMarkers,  ///< teaching saw fewer than three markers, or three on a line
  kHoldsStiffly,   ///< help can be changed where the robot gives way to forces
  kOutOfRange,     ///< the level of help is not within 0 and 1
  kQueueFull,      ///< refused at once; ask again
};
/// "accepted", "not_now", ...
[[nodiscard]] std::string_view id(Answer answer);

}  // namespace mirrorarm::station
