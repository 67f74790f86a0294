#include "app/workstation/session_tour.h"

namespace mirrorarm::workstation {
namespace {

using therapy::Phase;

bool isIn(Phase phase, const ui::SessionState& state) { return state.phase == phase && !state.stopped; }

}  // namespace

// The last stages show the report once its button to open it is there.
std::vector<Tour::Stage> SessionTour::stages(const ui::SessionPresenter& session) {
  const auto in = [&session](Phase phase) {
    return [&session, phase] { return isIn(phase, session.state()); };
  };
  const auto stopped = [&session] { return session.state().stopped; };
  const auto can_reset = [&session] { return session.state().can_reset; };
  const auto can_report = [&session] { return session.state().can_report; };
  return {{in(Phase::kPrepare), Seconds(2.5), "1-prepare", "teachButton"},
          {in(Phase::kTeaching), Seconds(3.0), "2-teach", "keepMarkersButton"},
          {in(Phase::kTaught), Seconds(2.5), "3-align", "alignButton"},
          {in(Phase::kAligned), Seconds(1.5), "4-ready", "startButton"},
          {in(Phase::kTraining), Seconds(12.0), "5-train", "imagesButton"},
          {in(Phase::kTraining), Seconds(1.5), "6-images", "imagesButton"},
          {in(Phase::kTraining), Seconds(1.0), "", "stopButton"},
          {stopped, Seconds(1.0), "7-stopped", "acknowledgeButton", true},
          {can_reset, Seconds(0.3), "", "resetStopButton", true},
          {in(Phase::kPaused), Seconds(0.5), "8-paused", "startButton", true},  // the reset may be under way
          {in(Phase::kTraining), Seconds(5.0), "", "themeButton"},
          {in(Phase::kTraining), Seconds(1.0), "9-dark", "themeButton"},
          {in(Phase::kTraining), Seconds(0.5), "", "finishButton"},
          {can_report, Seconds(0.5), "", "makeReportButton"},
          {can_report, Seconds(4.0), "10-report", ""}};
}

SessionTour::SessionTour(ui::MainWindow& window, std::filesystem::path folder)
    : Tour(window, stages(window.session()), std::move(folder)), session_(window.session()) {}

bool SessionTour::isInterrupted() {
  const auto& state = session_.state();
  if (state.stopped && !stage().stop_wanted) {
    if (state.can_reset) press("resetStopButton");
    resuming_ = true;
  } else if (resuming_ && isIn(Phase::kPaused, state)) {
    press("startButton");
  } else {
    resuming_ = false;
  }
  return resuming_;
}

}  // namespace mirrorarm::workstation
