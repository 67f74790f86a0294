#include "ui/panels/header_bar.h"

#include <QHBoxLayout>
#include <QVariant>

#include "ui/model/words.h"
#include "ui/panels/action_button.h"
#include "ui/panels/text.h"

namespace mirrorarm::ui {
namespace {

constexpr int kHeight_px = 48;

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
    : QFrame(parent), session_(makeText("muted")), recording_(makeText("muted")) {
  setObjectName(QStringLiteral("header"));
  setFixedHeight(kHeight_px);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(16, 0, 12, 0);
  row->setSpacing(10);
  auto* name = new QLabel(QStringLiteral("mirrorarm"));
  name->setObjectName(QStringLiteral("productName"));
  row->addWidget(name);
  row->addWidget(session_);
  row->addWidget(recording_);
  row->addStretch();
  add(*row, "viewButton", tr("Reset view"), QStringLiteral("Ctrl+0"), &HeaderBar::viewWanted);
  add(*row, "imagesButton", tr("Camera images"), QStringLiteral("Ctrl+I"), &HeaderBar::imagesWanted);
  add(*row, "themeButton", tr("Light or dark"), QStringLiteral("Ctrl+D"), &HeaderBar::themeWanted);
  add(*row, "keysButton", tr("Keys"), QStringLiteral("F1"), &HeaderBar::keysWanted);
  if (simulated) {
    auto* mark = new QLabel(tr("SIMULATION"));
    mark->setObjectName(QStringLiteral("simulationMark"));
    mark->setToolTip(tr("Robot, cameras and patient are simulated"));
    row->addWidget(mark, 0, Qt::AlignVCenter);
  }
  show(station::RecordState{});
}

void HeaderBar::add(QHBoxLayout& row, const char* name, const QString& text, const QKeySequence& key,
                    void (HeaderBar::*wanted)()) {
  auto* button = new ActionButton(QLatin1String(name), text, key);
  button->setProperty("quiet", true);
  button->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  connect(button, &QPushButton::clicked, this, wanted);
  row.addWidget(button);
}

void HeaderBar::show(const station::RecordState& record) {
  session_->setText(record.session == 0 ? tr("No session yet") : tr("Session %1").arg(record.session));
  recording_->setText(signOf(record.recording) + QLatin1Char(' ') + words(record.recording));
}

}  // namespace mirrorarm::ui
