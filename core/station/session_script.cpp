#include "core/station/session_script.h"

#include <utility>

namespace mirrorarm::station {

using therapy::Action;

namespace {

constexpr Seconds kStepTimeout{10.0};   ///< for everything that is not teaching or training
constexpr Seconds kPatientSettles{1.0};  ///< until an arm that was told to rest does rest
constexpr Seconds kThinkBeforeRestart{1.0};

std::string_view nameOf(Action action) { return id(action); }

}  // namespace

SessionScript::SessionScript(StationPort& station, const ScriptSettings& settings,
                             std::function<void(bool)> instruct)
    : station_(station), settings_(settings), instruct_(std::move(instruct)) {}

SessionScript::Progress SessionScript::step(TimePoint now) {
  seen_ = station_.snapshot();
  if (stage_since_ == TimePoint{}) stage_since_ = now;
  const Seconds waited = now - stage_since_;
  if (stage_ != Stage::kTrain && stage_ != Stage::kTeach && stage_ != Stage::kDone && waited > kStepTimeout)
    return fail("timeout in phase " + std::string(id(seen_.control.phase)));
  switch (stage_) {
    case Stage::kWait:
      if (!seen_.frame || !seen_.frame->observation.points.size()) break;
      ask(Action::kTeach);
      instruct_(true);
      go(Stage::kTeach, now);
      break;
    case Stage::kTeach:
      if (waited < settings_.teaching) break;
      instruct_(false);
      ask(Action::kFinishTeaching);
      go(Stage::kEndTeaching, now);
      break;
    case Stage::kEndTeaching: return afterAnswer(Stage::kRest, now);
    case Stage::kRest:
      if (waited < kPatientSettles || !seen_.control.target_fresh) break;
      ask(Action::kAlign);
      go(Stage::kAlign, now);
      break;
    case Stage::kAlign:
      if (const auto progress = afterAnswer(Stage::kStart, now); stage_ != Stage::kStart) return progress;
      ask(Action::kStart);
      started_at_ = now;
      train_until_ = now + toClock(settings_.training);
      break;
    case Stage::kStart: return afterAnswer(Stage::kTrain, now);
    case Stage::kTrain: return train(now);
    case Stage::kRestart:
      if (waited < kThinkBeforeRestart || !seen_.control.target_fresh || !seen_.control.servo.at_rest) break;
      ask(Action::kStart);
      go(Stage::kStart, now);
      break;
    case Stage::kFinish:
      if (seen_.record.recording != Recording::kWriting) go(Stage::kDone, now);
      break;
    case Stage::kDone: return Progress::kDone;
  }
  return Progress::kRunning;
}

SessionScript::Progress SessionScript::train(TimePoint now) {
  instruct_(true);
  const bool over = now >= train_until_;
  if (!over && seen_.control.servo.stop == control::StopReason::kNone) return Progress::kRunning;
  instruct_(false);
  if (over) {
    ask(Action::kFinish);
    go(Stage::kFinish, now);
    return Progress::kRunning;
  }
  if (++stops_ > settings_.max_restarts) return fail("stop." + std::string(id(seen_.control.servo.stop)));
  station_.resetStop();
  go(Stage::kRestart, now);
  return Progress::kRunning;
}

SessionScript::Progress SessionScript::afterAnswer(Stage next, TimePoint now) {
  if (!answered()) return Progress::kRunning;
  if (!accepted()) return fail(std::string(id(seen_.control.last_answer)));
  go(next, now);
  return Progress::kRunning;
}

SessionScript::Progress SessionScript::fail(std::string why) {
  failure_ = std::move(why);
  instruct_(false);
  stage_ = Stage::kDone;
  return Progress::kFailed;
}

void SessionScript::go(Stage stage, TimePoint now) {
  stage_ = stage;
  stage_since_ = now;
}

void SessionScript::ask(Action action) {
  answers_before_ = seen_.control.answers;
  if (station_.request({action, settings_.mapping}) != Answer::kAccepted)
    failure_ = std::string(nameOf(action)) + ".queue_full";
}

}  // namespace mirrorarm::station
