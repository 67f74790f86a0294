#include "core/station/session_script.h"

#include <utility>

namespace mirrorarm::station {

using therapy::Action;

namespace {

constexpr Seconds kStepTimeout{10.0};    // for everything that is not teaching or training
constexpr Seconds kPatientSettles{1.0};  // until an arm that was told to rest does rest

}  // namespace

SessionScript::SessionScript(StationPort& station, const ScriptSettings& settings,
                             std::function<void(bool)> instruct)
    : station_(station), settings_(settings), instruct_(std::move(instruct)) {}

SessionScript::Progress SessionScript::step(TimePoint now) {
  seen_ = station_.snapshot();
  now_ = now;
  if (stage_since_ == TimePoint{}) stage_since_ = now;
  noteStop();
  switch (stage_) {
    case Stage::kWait:
      return waitForMarkers();
    case Stage::kTeach:
      return teach();
    case Stage::kEndTeaching:
      return afterAnswer(Stage::kRest);
    case Stage::kRest:
      return settle(Action::kAlign, Stage::kAlign);
    case Stage::kAlign:
      return start();
    case Stage::kStart:
      return afterAnswer(Stage::kTrain);
    case Stage::kTrain:
      return train();
    case Stage::kRestart:
      return restart();
    case Stage::kFinish:
      return waitForRecord();
    case Stage::kDone:
      return failure_.empty() ? Progress::kDone : Progress::kFailed;
  }
  return Progress::kFailed;
}

SessionScript::Progress SessionScript::waitForMarkers() {
  if (!seen_.frame || seen_.frame->observation.points.empty()) return patience();
  instruct_(true);
  return ask(Action::kTeach, Stage::kTeach);
}

SessionScript::Progress SessionScript::teach() {
  const bool ended = seen_.control.phase == therapy::Phase::kTaught;  // precise enough, by itself
  if (waited() < settings_.teaching && !ended) return Progress::kRunning;
  instruct_(false);
  return ask(Action::kFinishTeaching, Stage::kEndTeaching);
}

void SessionScript::noteStop() {
  const bool stopped = seen_.control.servo.stop != control::StopReason::kNone;
  if (stopped && !stopped_) ++stops_;
  stopped_ = stopped;
}

// A stop is reset when the robot rests and the cause is gone.
bool SessionScript::clearsStop() {
  if (stopped_ && seen_.control.servo.reset == control::ResetRefusal::kNone) station_.resetStop();
  return stopped_;
}

// Aligned and started at rest: the patient sits still and the robot stands.
SessionScript::Progress SessionScript::settle(Action action, Stage next) {
  if (clearsStop() || waited() < kPatientSettles || !seen_.control.target_fresh ||
      !seen_.control.servo.at_rest)
    return patience();
  return ask(action, next);
}

SessionScript::Progress SessionScript::start() {
  const auto progress = afterAnswer(Stage::kStart);
  if (stage_ != Stage::kStart) return progress;
  train_until_ = now_ + toClock(settings_.training);
  return ask(Action::kStart, Stage::kStart);
}

SessionScript::Progress SessionScript::train() {
  const bool over = now_ >= train_until_;
  instruct_(!over && !stopped_);
  if (over) return ask(Action::kFinish, Stage::kFinish);
  if (!stopped_) return Progress::kRunning;
  if (stops_ > settings_.max_restarts) return giveUp();
  go(Stage::kRestart);
  return Progress::kRunning;
}

SessionScript::Progress SessionScript::restart() {
  if (!clearsStop()) return settle(Action::kStart, Stage::kStart);
  return waited() < kStepTimeout ? Progress::kRunning : giveUp();
}

std::string SessionScript::lastingStop() const { return "stop." + std::string(id(seen_.control.servo.stop)); }

SessionScript::Progress SessionScript::giveUp() {
  failure_ = lastingStop();
  return ask(Action::kFinish, Stage::kFinish);
}

SessionScript::Progress SessionScript::waitForRecord() {
  if (!answered() || seen_.record.recording == Recording::kWriting) return patience();
  go(Stage::kDone);
  return failure_.empty() ? Progress::kDone : Progress::kFailed;
}

SessionScript::Progress SessionScript::afterAnswer(Stage next) {
  if (!answered()) return patience();
  if (seen_.control.last_answer != Answer::kAccepted) return fail(std::string(id(seen_.control.last_answer)));
  go(next);
  return Progress::kRunning;
}

SessionScript::Progress SessionScript::ask(Action action, Stage next) {
  answers_before_ = seen_.control.answers;
  const auto answer = station_.request({action, settings_.mapping});
  if (answer != Answer::kAccepted) return fail(std::string(id(answer)));
  go(next);
  return Progress::kRunning;
}

SessionScript::Progress SessionScript::patience() {
  if (waited() < kStepTimeout) return Progress::kRunning;
  return fail(stopped_ ? lastingStop() : "nothing came in phase " + std::string(id(seen_.control.phase)));
}

SessionScript::Progress SessionScript::fail(std::string why) {
  if (failure_.empty()) failure_ = std::move(why);
  instruct_(false);
  stage_ = Stage::kDone;
  return Progress::kFailed;
}

void SessionScript::go(Stage stage) {
  stage_ = stage;
  stage_since_ = now_;
}

}  // namespace mirrorarm::station
