#include "ui/panels/header_frame.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QVariant>

#include "ui/panels/action_button.h"

namespace mirrorarm::ui {
namespace {

constexpr int kHeight_px = 48;
constexpr int kGap_px = 10;

QLabel* makeSimulationMark() {
  auto* mark = new QLabel(HeaderFrame::tr("SIMULATION"));
  mark->setObjectName(QStringLiteral("simulationMark"));
  mark->setToolTip(
      HeaderFrame::tr("Cameras and patient are simulated, and the robot unless another one was chosen"));
  return mark;
}

}  // namespace

HeaderFrame::HeaderFrame(bool simulated, QWidget* parent)
    : QFrame(parent), left_(new QHBoxLayout), actions_(new QHBoxLayout) {
  setObjectName(QStringLiteral("header"));
  setFixedHeight(kHeight_px);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(16, 0, 12, 0);
  row->setSpacing(kGap_px);
  left_->setSpacing(kGap_px);
  actions_->setSpacing(kGap_px);
  auto* name = new QLabel(QStringLiteral("mirrorarm"));
  name->setObjectName(QStringLiteral("productName"));
  row->addWidget(name);
  row->addLayout(left_);
  row->addStretch();
  row->addLayout(actions_);
  if (simulated) row->addWidget(makeSimulationMark(), 0, Qt::AlignVCenter);
}

void HeaderFrame::addLeft(QWidget* widget) { left_->addWidget(widget); }

ActionButton* HeaderFrame::addAction(const char* name, const QString& text, const QKeySequence& key) {
  auto* button = new ActionButton(QLatin1String(name), text, key);
  button->setProperty("quiet", true);
  button->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  actions_->addWidget(button);
  return button;
}

}  // namespace mirrorarm::ui
