#include "ui/model/journal.h"

#include "ui/model/words.h"

namespace mirrorarm::ui {

void Journal::show(const station::Snapshot& snapshot) {
  const auto& control = snapshot.control;
  const int reteachings = snapshot.frame ? snapshot.frame->reteachings : 0;
  const Seen now{control.phase, control.servo.stop, snapshot.record.recording, control.answers, reteachings};
  if (before_) compare(*before_, now, control.last_answer);
  before_ = now;
}

void Journal::compare(const Seen& before, const Seen& now, station::Answer answer) {
  if (now.phase != before.phase) log_.add(words(now.phase));
  if (now.answers != before.answers && answer != station::Answer::kAccepted)
    log_.add(LogModel::tr("Refused: %1").arg(words(answer)));
  const bool freed = now.stop == control::StopReason::kNone && now.stop != before.stop;
  if (freed) log_.add(LogModel::tr("Stop reset"));
  if (now.recording != before.recording) log_.add(words(now.recording));
  if (now.reteachings > before.reteachings) log_.add(LogModel::tr("The markers were taught anew"));
}

}  // namespace mirrorarm::ui
