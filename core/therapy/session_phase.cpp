#include "core/therapy/session_phase.h"

#include <algorithm>
#include <array>

namespace mirrorarm::therapy {
namespace {

struct Step {
  Phase from;
  Action action;
  Phase to;
};

// Teaching and aligning may be repeated until training begins; a frame that slipped may be aligned anew in a
// pause. A session that has begun is finished before the next one.
constexpr std::array kSteps{
    Step{Phase::kPrepare, Action::kTeach, Phase::kTeaching},
    Step{Phase::kTeaching, Action::kFinishTeaching, Phase::kTaught},
    Step{Phase::kTeaching, Action::kNewSession, Phase::kPrepare},
    Step{Phase::kTaught, Action::kTeach, Phase::kTeaching},
    Step{Phase::kTaught, Action::kAlign, Phase::kAligned},
    Step{Phase::kTaught, Action::kNewSession, Phase::kPrepare},
    Step{Phase::kAligned, Action::kTeach, Phase::kTeaching},
    Step{Phase::kAligned, Action::kAlign, Phase::kAligned},
    Step{Phase::kAligned, Action::kStart, Phase::kTraining},
    Step{Phase::kAligned, Action::kNewSession, Phase::kPrepare},
    Step{Phase::kTraining, Action::kPause, Phase::kPaused},
    Step{Phase::kTraining, Action::kFinish, Phase::kFinished},
    Step{Phase::kPaused, Action::kAlign, Phase::kPaused},
    Step{Phase::kPaused, Action::kStart, Phase::kTraining},
    Step{Phase::kPaused, Action::kFinish, Phase::kFinished},
    Step{Phase::kFinished, Action::kNewSession, Phase::kPrepare},
};

}  // namespace

std::string_view id(Phase phase) {
  switch (phase) {
    case Phase::kPrepare:
      return "prepare";
    case Phase::kTeaching:
      return "teaching";
    case Phase::kTaught:
      return "taught";
    case Phase::kAligned:
      return "aligned";
    case Phase::kTraining:
      return "training";
    case Phase::kPaused:
      return "paused";
    case Phase::kFinished:
      return "finished";
  }
  return "unknown";
}

std::string_view id(Action action) {
  switch (action) {
    case Action::kTeach:
      return "teach";
    case Action::kFinishTeaching:
      return "finish_teaching";
    case Action::kAlign:
      return "align";
    case Action::kStart:
      return "start";
    case Action::kPause:
      return "pause";
    case Action::kFinish:
      return "finish";
    case Action::kNewSession:
      return "new_session";
  }
  return "unknown";
}

std::optional<Phase> after(Phase phase, Action action) {
  const auto step = std::ranges::find_if(
      kSteps, [&](const Step& candidate) { return candidate.from == phase && candidate.action == action; });
  if (step == kSteps.end()) return std::nullopt;
  return step->to;
}

}  // namespace mirrorarm::therapy
