#include "ui/model/session_presenter.h"

#include <cmath>

#include "ui/model/words.h"

namespace mirrorarm::ui {
namespace {

using therapy::Action;
using therapy::Phase;

struct Guide {
  std::optional<Action> primary;
  QString title;
  QString instruction;
};

Guide guideOf(Phase phase) {
  switch (phase) {
    case Phase::kPrepare:
      return {Action::kTeach, SessionPresenter::tr("Prepare the patient"),
              SessionPresenter::tr(
                  "Fasten the impaired arm in the sling and turn the markers of the healthy forearm to the "
                  "cameras.")};
    case Phase::kTeaching:
      return {Action::kFinishTeaching, SessionPresenter::tr("Teach the markers"),
              SessionPresenter::tr(
                  "Let the patient turn the healthy forearm slowly until every marker has been seen.")};
    case Phase::kTaught:
      return {Action::kAlign, SessionPresenter::tr("Align both arms"),
              SessionPresenter::tr(
                  "Bring both arms into the start position and hold them still. Movements count from here.")};
    case Phase::kAligned:
      return {Action::kStart, SessionPresenter::tr("Ready to train"),
              SessionPresenter::tr("The robot moves as soon as you start. Keep a hand near STOP.")};
    case Phase::kTraining:
      return {Action::kPause, SessionPresenter::tr("Training"),
              SessionPresenter::tr("The robot carries the impaired arm along with the healthy one.")};
    case Phase::kPaused:
      return {Action::kStart, SessionPresenter::tr("Paused"),
              SessionPresenter::tr("The robot rests. Go on, or finish the session.")};
    case Phase::kFinished:
      return {std::nullopt, SessionPresenter::tr("Session finished"),
              SessionPresenter::tr("Everything is recorded. Make the report, or begin anew.")};
  }
  return {};
}

QString minutesOf(double seconds) {
  const int whole = static_cast<int>(std::floor(seconds));
  return QStringLiteral("%1:%2").arg(whole / 60).arg(whole % 60, 2, 10, QLatin1Char('0'));
}

QString teachingProgress(const station::ControlState& control) {
  const QString markers = SessionPresenter::tr("Markers so far: %1").arg(control.taught_markers);
  const double sigma_mm = 1e3 * control.taught_sigma_m;
  if (control.taught_markers == 0 || !std::isfinite(sigma_mm)) return markers;
  return SessionPresenter::tr("%1  ·  known to %2 mm").arg(markers).arg(sigma_mm, 0, 'f', 3);
}

QString progressOf(const station::Snapshot& snapshot) {
  const auto& control = snapshot.control;
  switch (control.phase) {
    case Phase::kTeaching:
      return teachingProgress(control);
    case Phase::kTraining:
    case Phase::kPaused:
    case Phase::kFinished:
      return SessionPresenter::tr("%1 min  ·  Repetitions: %2")
          .arg(minutesOf(control.session_s))
          .arg(snapshot.record.measures.repetitions);
    default:
      return {};
  }
}

/// While a stop is latched a session can only be ended.
bool isAllowed(Action action, const SessionState& state) {
  return therapy::after(state.phase, action).has_value() && (!state.stopped || action == Action::kFinish);
}

void explainStop(const control::ServoState& servo, SessionState& state) {
  state.stopped = true;
  state.can_reset = servo.reset == control::ResetRefusal::kNone;
  state.primary.reset();
  state.title = SessionPresenter::tr("Stopped");
  state.instruction = words(servo.stop) + QStringLiteral(". ") + advice(servo.stop);
  if (state.message.isEmpty()) state.message = whyNoReset(servo);
}

}  // namespace

Step stepOf(Phase phase) {
  switch (phase) {
    case Phase::kPrepare:
      return Step::kPrepare;
    case Phase::kTeaching:
      return Step::kTeach;
    case Phase::kTaught:
      return Step::kAlign;
    case Phase::kAligned:
    case Phase::kTraining:
    case Phase::kPaused:
      return Step::kTrain;
    case Phase::kFinished:
      return Step::kReport;
  }
  return Step::kPrepare;
}

QString nameOf(Step step) {
  switch (step) {
    case Step::kPrepare:
      return SessionPresenter::tr("Prepare");
    case Step::kTeach:
      return SessionPresenter::tr("Teach");
    case Step::kAlign:
      return SessionPresenter::tr("Align");
    case Step::kTrain:
      return SessionPresenter::tr("Train");
    case Step::kReport:
      return SessionPresenter::tr("Report");
  }
  return {};
}

SessionPresenter::SessionPresenter(station::StationPort& port, QObject* parent)
    : QObject(parent), port_(port) {
  state_ = stateOf({});
}

SessionState SessionPresenter::stateOf(const station::Snapshot& snapshot) const {
  const auto& control = snapshot.control;
  Guide guide = guideOf(control.phase);
  SessionState next;
  next.phase = control.phase;
  next.step = stepOf(control.phase);
  next.primary = guide.primary;
  next.title = std::move(guide.title);
  next.instruction = std::move(guide.instruction);
  next.progress = progressOf(snapshot);
  next.message = message_;
  next.mapping = mapping_;
  next.enabling_needed = control.servo.enabling_needed;
  next.enabling = control.servo.enabling;
  if (control.servo.stop != control::StopReason::kNone) explainStop(control.servo, next);
  for (std::size_t i = 0; i < next.allowed.size(); ++i)
    next.allowed[i] = isAllowed(static_cast<Action>(i), next);
  next.can_choose_mapping = !next.stopped && control.phase == Phase::kTaught;  // aligning fixes it
  next.session = snapshot.record.session;
  next.can_calibrate = control.phase == Phase::kPrepare;
  next.can_report = snapshot.record.recording == station::Recording::kComplete;
  return next;
}

void SessionPresenter::show(const station::Snapshot& snapshot) {
  hear(snapshot.control);
  publish(stateOf(snapshot));
}

void SessionPresenter::hear(const station::ControlState& control) {
  if (control.answers == answers_heard_) return;
  answers_heard_ = control.answers;
  const bool accepted = control.last_answer == station::Answer::kAccepted;
  message_ = accepted ? QString() : words(control.last_answer);
}

void SessionPresenter::ask(Action action) {
  const auto answer = port_.request({action, mapping_});
  if (answer == station::Answer::kAccepted) return;
  message_ = words(answer);
  SessionState next = state_;
  next.message = message_;
  publish(std::move(next));
}

void SessionPresenter::setMapping(therapy::Mapping mapping) {
  mapping_ = mapping;
  SessionState next = state_;
  next.mapping = mapping_;
  publish(std::move(next));
}

void SessionPresenter::stop() { port_.stop(control::StopReason::kOperator); }

void SessionPresenter::resetStop() { port_.resetStop(); }

void SessionPresenter::setEnabling(control::EnablingPosition position) { port_.setEnabling(position); }

void SessionPresenter::publish(SessionState next) {
  if (next == state_) return;
  state_ = std::move(next);
  emit stateChanged(state_);
}

}  // namespace mirrorarm::ui
