#include "ui/wizards/progress_card.h"

#include <QVBoxLayout>
#include <QVariant>

#include "ui/panels/text.h"

namespace mirrorarm::ui {
namespace {

QString doing(const CalibrationState& state) {
  switch (state.phase) {
    case station::CalibrationPhase::kIdle:
      return ProgressCard::tr("Nothing has begun");
    case station::CalibrationPhase::kCapturing:
      return ProgressCard::tr("Captured: %1 %").arg(state.progress_percent);
    case station::CalibrationPhase::kSolving:
      return ProgressCard::tr("Solving: %1 %").arg(state.progress_percent);
    case station::CalibrationPhase::kSolved:
      return ProgressCard::tr("Solved; nothing is in force yet");
    case station::CalibrationPhase::kRefused:
      return ProgressCard::tr("Not solved; the views are kept");
    case station::CalibrationPhase::kAccepted:
      return ProgressCard::tr("Written and in force");
  }
  return {};
}

bool hasProgress(const CalibrationState& state) {
  return state.phase == station::CalibrationPhase::kCapturing ||
         state.phase == station::CalibrationPhase::kSolving;
}

}  // namespace

ProgressCard::ProgressCard(QWidget* parent)
    : QFrame(parent), what_(makeText("heading")), bar_(new QProgressBar), message_(makeText("notice")) {
  setObjectName(QStringLiteral("progressCard"));
  setProperty("card", true);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 10, 12, 10);
  column->setSpacing(6);
  bar_->setObjectName(QStringLiteral("progressBar"));
  bar_->setAccessibleName(tr("Progress"));
  bar_->setTextVisible(false);
  bar_->setRange(0, 100);
  message_->setObjectName(QStringLiteral("calibrationMessage"));
  message_->setWordWrap(true);
  column->addWidget(what_);
  column->addWidget(bar_);
  column->addWidget(message_);
  column->addStretch();
  show(CalibrationState{});
}

void ProgressCard::show(const CalibrationState& state) {
  what_->setText(doing(state));
  bar_->setVisible(hasProgress(state));
  bar_->setValue(state.progress_percent);
  message_->setText(state.message);
  message_->setVisible(!state.message.isEmpty());
}

}  // namespace mirrorarm::ui
