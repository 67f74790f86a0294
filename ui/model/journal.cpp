#include "ui/model/journal.h"

#include "ui/model/words.h"

namespace mirrorarm::ui {

void Journal::show(const station::Snapshot& snapshot) {
  const auto& control = snapshot.control;
  const auto skin = snapshot.frame ? snapshot.frame->skin_events : decltype(Seen::skin_events){};
  const Seen now{control.phase, control.servo.stop, control.help, snapshot.record.recording, control.answers,
                 skin};
  if (before_) compare(*before_, now, control.last_answer);
  before_ = now;
}

void Journal::compare(const Seen& before, const Seen& now, station::Answer answer) {
  if (now.phase != before.phase) log_.add(words(now.phase));
  if (now.answers != before.answers && answer != station::Answer::kAccepted)
    log_.add(LogModel::tr("Refused: %1").arg(words(answer)));
  const bool freed = now.stop == control::StopReason::kNone && now.stop != before.stop;
  if (freed) log_.add(LogModel::tr("Stop reset"));
  if (now.help != before.help) log_.add(words(now.help));
  if (now.recording != before.recording) log_.add(words(now.recording));
  for (std::size_t event = 1; event < now.skin_events.size(); ++event)
    if (now.skin_events[event] > before.skin_events[event])
      log_.add(words(static_cast<tracking::SkinEvent>(event)));
}

}  // namespace mirrorarm::ui
