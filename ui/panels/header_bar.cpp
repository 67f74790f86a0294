#include "ui/panels/header_bar.h"

#include "ui/model/words.h"
#include "ui/panels/action_button.h"
#include "ui/panels/text.h"

namespace mirrorarm::ui {
namespace {

/// A sign besides the word: a full disc while writing, a cross when it failed.
QString signOf(station::Recording recording) {
  switch (recording) {
    case station::Recording::kIdle:
      return QStringLiteral("○");
    case station::Recording::kWriting:
      return QStringLiteral("●");
    case station::Recording::kComplete:
      return QStringLiteral("✔");
    case station::Recording::kFailed:
      return QStringLiteral("✖");
  }
  return {};
}

}  // namespace

HeaderBar::HeaderBar(bool simulated, QWidget* parent)
    : HeaderFrame(simulated, parent), session_(makeText("muted")), recording_(makeText("muted")) {
  addLeft(session_);
  addLeft(recording_);
  calibrate_ =
      add("calibrateButton", tr("Calibrate"), QStringLiteral("Ctrl+K"), &HeaderBar::calibrationWanted);
  add("viewButton", tr("Reset view"), QStringLiteral("Ctrl+0"), &HeaderBar::viewWanted);
  add("imagesButton", tr("Camera images"), QStringLiteral("Ctrl+I"), &HeaderBar::imagesWanted);
  add("themeButton", tr("Light or dark"), QStringLiteral("Ctrl+D"), &HeaderBar::themeWanted);
  add("keysButton", tr("Keys"), QStringLiteral("F1"), &HeaderBar::keysWanted);
  show(station::RecordState{});
}

ActionButton* HeaderBar::add(const char* name, const QString& text, const QString& key,
                             void (HeaderBar::*wanted)()) {
  auto* button = addAction(name, text, QKeySequence(key));
  connect(button, &QPushButton::clicked, this, wanted);
  return button;
}

void HeaderBar::show(const station::RecordState& record) {
  session_->setText(record.session == 0 ? tr("No session yet") : tr("Session %1").arg(record.session));
  recording_->setText(signOf(record.recording) + QLatin1Char(' ') + words(record.recording));
}

void HeaderBar::setCalibrationAllowed(bool allowed) { calibrate_->setEnabled(allowed); }

}  // namespace mirrorarm::ui
