#pragma once

#include <optional>
#include <string_view>

namespace mirrorarm::therapy {

/// The steps of a session, in order. The robot moves in kTraining alone.
enum class Phase {
  kPrepare,   ///< equipment checked, nothing taught
  kTeaching,  ///< the markers are being learnt
  kTaught,    ///< a target is known and tracked
  kAligned,   ///< the reference frame is set
  kTraining,  ///< the robot follows
  kPaused,    ///< at rest, goes on with kStart
  kFinished,  ///< recorded; the report can be made
};
/// "prepare", "teaching", ...
[[nodiscard]] std::string_view id(Phase phase);

/// What an operator may ask for, besides stopping, which is never a request.
enum class Action { kTeach, kFinishTeaching, kAlign, kStart, kPause, kFinish, kNewSession };
/// "teach", ...
[[nodiscard]] std::string_view id(Action action);

/// The phase that `action` leads to, or nothing where it is not allowed: a pure function, so that the screen
/// and the station ask the same question.
[[nodiscard]] std::optional<Phase> after(Phase phase, Action action);

}  // namespace mirrorarm::therapy
