#include "app/workstation/tour.h"

#include <chrono>
#include <iostream>

#include <QAbstractButton>

#include "app/workstation/exit_code.h"

namespace mirrorarm::workstation {
namespace {

using therapy::Phase;
using ui::SessionState;

constexpr Seconds kPatience{60.0};  // for a machine without graphics hardware

auto in(Phase phase) {
  return [phase](const SessionState& state) { return state.phase == phase && !state.stopped; };
}

bool isStopped(const SessionState& state) { return state.stopped; }
bool canReport(const SessionState& state) { return state.can_report; }

}  // namespace

// The last stages show the report once its button to open it is there.
std::vector<Tour::Stage> Tour::stages() {
  return {{in(Phase::kPrepare), Seconds(2.5), "1-prepare", "teachButton"},
          {in(Phase::kTeaching), Seconds(3.0), "2-teach", "keepMarkersButton"},
          {in(Phase::kTaught), Seconds(2.5), "3-align", "alignButton"},
          {in(Phase::kAligned), Seconds(1.5), "4-ready", "startButton"},
          {in(Phase::kTraining), Seconds(12.0), "5-train", "imagesButton"},
          {in(Phase::kTraining), Seconds(1.5), "6-images", "imagesButton"},
          {in(Phase::kTraining), Seconds(1.0), "", "stopButton"},
          {isStopped, Seconds(1.0), "7-stopped", "acknowledgeButton", true},
          {isStopped, Seconds(0.3), "", "resetStopButton", true},
          {in(Phase::kPaused), Seconds(0.5), "8-paused", "startButton"},
          {in(Phase::kTraining), Seconds(5.0), "", "themeButton"},
          {in(Phase::kTraining), Seconds(1.0), "9-dark", "themeButton"},
          {in(Phase::kTraining), Seconds(0.5), "", "finishButton"},
          {canReport, Seconds(0.5), "", "makeReportButton"},
          {canReport, Seconds(4.0), "10-report", ""}};
}

Tour::Tour(ui::MainWindow& window, std::filesystem::path folder)
    : window_(window), folder_(std::move(folder)), stages_(stages()) {
  timer_.setInterval(std::chrono::milliseconds(100));
  connect(&timer_, &QTimer::timeout, this, &Tour::look);
}

void Tour::start() {
  std::filesystem::create_directories(folder_);
  waiting_since_ = Clock::now();
  timer_.start();
}

void Tour::look() {
  const TimePoint now = Clock::now();
  const Stage& stage = stages_[stage_];
  const SessionState& state = window_.session().state();
  const bool ready = !isInterrupted(state) && stage.ready(state);
  if (ready && !ready_) ready_since_ = now;
  ready_ = ready_ || ready;
  if (ready && now - ready_since_ >= stage.settle) return act(stage);
  if (now - waiting_since_ > kPatience)
    fail("the tour waited in vain before '" + std::string(*stage.press != '\0' ? stage.press : stage.shot) +
         "'");
}

// A target that left the view stops the robot; a therapist resets that and goes on.
bool Tour::isInterrupted(const SessionState& state) {
  if (state.stopped && !stages_[stage_].stop_wanted) {
    press("resetStopButton");
    resuming_ = true;
  } else if (resuming_ && in(Phase::kPaused)(state)) {
    press("startButton");
  } else {
    resuming_ = false;
  }
  return resuming_;
}

void Tour::act(const Stage& stage) {
  if (*stage.shot != '\0') take(stage.shot);
  if (*stage.press != '\0') press(stage.press);
  if (timer_.isActive()) next();
}

void Tour::next() {
  ready_ = false;
  waiting_since_ = Clock::now();
  if (++stage_ < stages_.size()) return;
  timer_.stop();
  emit finished(kDone);
}

void Tour::take(const char* shot) {
  const auto file = folder_ / (std::string(shot) + ".png");
  if (!window_.grab().save(QString::fromStdString(file.string())))
    fail(file.string() + ": cannot be written");
}

void Tour::press(const char* name) {
  auto* button = window_.findChild<QAbstractButton*>(QLatin1String(name));
  if (button != nullptr && button->isVisible() && button->isEnabled()) return button->click();
  fail(std::string("the tour found no button '") + name + "' to press");
}

void Tour::fail(const std::string& reason) {
  timer_.stop();
  std::cerr << "mirrorarm: " << reason << "\n";
  emit finished(kFailed);
}

}  // namespace mirrorarm::workstation
