#include "app/workstation/tour.h"

#include <chrono>
#include <iostream>

#include <QAbstractButton>

#include "app/workstation/exit_code.h"

namespace mirrorarm::workstation {

Tour::Tour(QWidget& window, std::vector<Stage> stages, std::filesystem::path folder)
    : window_(window), folder_(std::move(folder)), stages_(std::move(stages)) {
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
  const bool ready = !isInterrupted() && stage.ready();
  if (ready && !ready_) ready_since_ = now;
  ready_ = ready_ || ready;
  if (ready && now - ready_since_ >= stage.settle) return act(stage);
  if (now - waiting_since_ > stage.patience)
    fail("the tour waited in vain before '" + std::string(*stage.press != '\0' ? stage.press : stage.shot) +
         "'");
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
