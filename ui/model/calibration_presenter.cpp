#include "ui/model/calibration_presenter.h"

#include <algorithm>
#include <cmath>

#include "ui/model/calibration_guide.h"
#include "ui/model/calibration_words.h"
#include "ui/model/words.h"

namespace mirrorarm::ui {
namespace {

using station::CalibrationAction;
using station::CalibrationAnswer;
using station::CalibrationJob;
using station::CalibrationPhase;
using station::CalibrationSnapshot;

constexpr Seconds kWordsEvery{0.5};  // so that an instruction can be read

/// What stands on what: the next one to do after each.
CalibrationJob after(CalibrationJob job) {
  switch (job) {
    case CalibrationJob::kStereo:
      return CalibrationJob::kHandEye;
    case CalibrationJob::kHandEye:
      return CalibrationJob::kClock;
    case CalibrationJob::kClock:
    case CalibrationJob::kDrift:
      return CalibrationJob::kDrift;
  }
  return job;
}

bool hasViews(const CalibrationSnapshot& snapshot) { return snapshot.views && !snapshot.views->empty(); }

bool isAllowed(CalibrationAction action, const CalibrationSnapshot& snapshot) {
  const bool idle =
      snapshot.phase == CalibrationPhase::kIdle || snapshot.phase == CalibrationPhase::kAccepted;
  const bool capturing = snapshot.phase == CalibrationPhase::kCapturing;
  const bool of_movement = snapshot.job == CalibrationJob::kClock;
  switch (action) {
    case CalibrationAction::kBegin:
      return idle;
    case CalibrationAction::kCapture:
    case CalibrationAction::kSetAutomatic:
      return capturing && !of_movement;
    case CalibrationAction::kSetDriving:
      return capturing && snapshot.servo.stop == control::StopReason::kNone;
    case CalibrationAction::kRemoveView:
      return capturing && hasViews(snapshot);
    case CalibrationAction::kUndoRemove:
      return capturing && snapshot.can_undo;
    case CalibrationAction::kSolve:
      return capturing && (of_movement ? snapshot.progress > 0.0 : hasViews(snapshot));
    case CalibrationAction::kAccept:
      return snapshot.phase == CalibrationPhase::kSolved;
    case CalibrationAction::kDiscard:
      return snapshot.phase == CalibrationPhase::kSolved || snapshot.phase == CalibrationPhase::kRefused;
    case CalibrationAction::kCancel:
      return !idle;
  }
  return false;
}

}  // namespace

CalibrationStep stepOf(CalibrationPhase phase) {
  switch (phase) {
    case CalibrationPhase::kIdle:
      return CalibrationStep::kChoose;
    case CalibrationPhase::kCapturing:
      return CalibrationStep::kCapture;
    case CalibrationPhase::kSolving:
    case CalibrationPhase::kRefused:
      return CalibrationStep::kSolve;
    case CalibrationPhase::kSolved:
    case CalibrationPhase::kAccepted:
      return CalibrationStep::kResult;
  }
  return CalibrationStep::kChoose;
}

QString nameOf(CalibrationStep step) {
  switch (step) {
    case CalibrationStep::kChoose:
      return CalibrationPresenter::tr("Choose");
    case CalibrationStep::kCapture:
      return CalibrationPresenter::tr("Capture");
    case CalibrationStep::kSolve:
      return CalibrationPresenter::tr("Solve");
    case CalibrationStep::kResult:
      return CalibrationPresenter::tr("Result");
  }
  return {};
}

CalibrationPresenter::CalibrationPresenter(station::CalibrationPort& port, const calibration::Board& board,
                                           QObject* parent)
    : QObject(parent), port_(port) {
  wish_.board = board;
  state_ = stateOf({});
}

CalibrationState CalibrationPresenter::stateOf(const CalibrationSnapshot& snapshot) const {
  CalibrationState next;
  next.phase = snapshot.phase;
  next.step = stepOf(snapshot.phase);
  next.can_choose = isAllowed(CalibrationAction::kBegin, snapshot);
  next.job = next.can_choose ? wish_.job : snapshot.job;
  next.stopped = snapshot.servo.stop != control::StopReason::kNone;
  CalibrationGuide guide = guideOf(snapshot, wish_.job, result_.light);
  next.title = std::move(guide.title);
  next.instruction = std::move(guide.instruction);
  next.primary = guide.primary;
  next.enabling_needed = snapshot.servo.enabling_needed;
  next.enabling = snapshot.servo.enabling;
  next.can_reset = snapshot.servo.reset == control::ResetRefusal::kNone;
  next.message = message_.isEmpty() ? whyNoReset(snapshot.servo) : message_;
  for (std::size_t i = 0; i < next.allowed.size(); ++i)
    next.allowed[i] = isAllowed(static_cast<CalibrationAction>(i), snapshot);
  next.automatic = snapshot.automatic;
  next.driving = snapshot.driving;
  next.progress_percent = static_cast<int>(std::lround(100.0 * std::clamp(snapshot.progress, 0.0, 1.0)));
  if (next.step == CalibrationStep::kCapture) next.lights = captureLights(snapshot);
  return next;
}

void CalibrationPresenter::show(const CalibrationSnapshot& snapshot, TimePoint now) {
  hear(snapshot);
  judge(snapshot);
  CalibrationState next = stateOf(snapshot);
  const bool same_step = next.phase == state_.phase && next.stopped == state_.stopped;
  if (same_step && now - worded_at_ < kWordsEvery) {
    next.title = state_.title;
    next.instruction = state_.instruction;
    next.primary = state_.primary;
  } else if (next.title != state_.title || next.instruction != state_.instruction) {
    worded_at_ = now;
  }
  publish(std::move(next));
}

void CalibrationPresenter::hear(const CalibrationSnapshot& snapshot) {
  if (snapshot.phase == CalibrationPhase::kAccepted && state_.phase != CalibrationPhase::kAccepted)
    wish_.job = after(snapshot.job);
  if (snapshot.answers == answers_heard_) return;
  answers_heard_ = snapshot.answers;
  const bool accepted = snapshot.last_answer == CalibrationAnswer::kAccepted;
  message_ = accepted ? QString() : words(snapshot.last_answer);
}

void CalibrationPresenter::judge(const CalibrationSnapshot& snapshot) {
  if (snapshot.outcome == judged_) return;
  judged_ = snapshot.outcome;
  result_ = judged_ ? resultOf(*judged_) : CalibrationResult{};
  emit resultChanged(result_);
}

void CalibrationPresenter::choose(CalibrationJob job) {
  if (!state_.can_choose) return;
  wish_.job = job;
  CalibrationState next = state_;
  next.job = job;
  worded_at_ = {};
  publish(std::move(next));
}

void CalibrationPresenter::ask(CalibrationAction action) {
  station::CalibrationCommand command = wish_;
  command.action = action;
  send(command);
}

void CalibrationPresenter::setAutomatic(bool on) {
  send({.action = CalibrationAction::kSetAutomatic, .board = wish_.board, .model = {}, .on = on});
}

void CalibrationPresenter::setDriving(bool on) {
  send({.action = CalibrationAction::kSetDriving, .board = wish_.board, .model = {}, .on = on});
}

void CalibrationPresenter::removeView(std::size_t view) {
  send({.action = CalibrationAction::kRemoveView, .board = wish_.board, .model = {}, .view = view});
}

void CalibrationPresenter::send(const station::CalibrationCommand& command) {
  const auto answer = port_.request(command);
  if (answer == CalibrationAnswer::kAccepted) return;
  message_ = words(answer);
  CalibrationState next = state_;
  next.message = message_;
  publish(std::move(next));
}

void CalibrationPresenter::stop() { port_.stop(control::StopReason::kOperator); }

void CalibrationPresenter::resetStop() { port_.resetStop(); }

void CalibrationPresenter::setEnabling(control::EnablingPosition position) { port_.setEnabling(position); }

void CalibrationPresenter::publish(CalibrationState next) {
  if (next == state_) return;
  state_ = std::move(next);
  emit stateChanged(state_);
}

}  // namespace mirrorarm::ui
