#include "ui/panels/alarm_bar.h"

#include <chrono>

#include <QHBoxLayout>

#include "ui/panels/action_button.h"
#include "ui/panels/priority_sign.h"
#include "ui/panels/text.h"

namespace mirrorarm::ui {
namespace {

struct Ground {
  const char* ground;
  const char* text;
};

Ground groundOf(const Alarm* alarm) {
  if (alarm == nullptr || !alarm->active) return {"surface", "text"};
  switch (alarm->condition.priority) {
    case Priority::kHigh:
      return {"alarm_high", "on_alarm_high"};
    case Priority::kMedium:
      return {"alarm_medium", "on_alarm_medium"};
    case Priority::kLow:
      return {"alarm_low", "on_alarm_low"};
  }
  return {"surface", "text"};
}

}  // namespace

AlarmBar::AlarmBar(AlarmList& alarms, QWidget* parent)
    : QFrame(parent),
      alarms_(alarms),
      sign_(new PrioritySign),
      priority_(makeText("figure")),
      text_(makeText("plain")),
      more_(makeText("plain")),
      acknowledge_(new ActionButton(QStringLiteral("acknowledgeButton"), tr("Acknowledge"),
                                    QKeySequence(Qt::Key_F9))) {
  setObjectName(QStringLiteral("alarmBar"));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(12, 4, 6, 4);
  row->setSpacing(10);
  for (QWidget* widget : std::initializer_list<QWidget*>{sign_, priority_, text_}) row->addWidget(widget);
  row->addStretch();
  row->addWidget(more_);
  row->addWidget(acknowledge_);
  acknowledge_->setMinimumWidth(160);
  setFixedHeight(48);
  flash_.setInterval(std::chrono::milliseconds(250));
  connect(&flash_, &QTimer::timeout, this, [this] {
    flash_dark_ = !flash_dark_;
    paintGround();
  });
  connect(acknowledge_, &QPushButton::clicked, &alarms_, &AlarmList::acknowledge);
  connect(&alarms_, &AlarmList::changed, this, &AlarmBar::draw);
}

void AlarmBar::setTheme(const Theme& theme) {
  theme_ = theme;
  draw();
}

void AlarmBar::draw() {
  const auto& alarms = alarms_.alarms();
  const Alarm* first = alarms.isEmpty() ? nullptr : &alarms.first();
  sign_->setPriority(first != nullptr ? std::optional(first->condition.priority) : std::nullopt);
  priority_->setText(first == nullptr ? tr("No alarms") : nameOf(first->condition.priority));
  const QString over = first != nullptr && !first->active ? tr(" (is over)") : QString();
  text_->setText(first == nullptr ? QString() : first->condition.text + over);
  more_->setText(alarms.size() > 1 ? tr("%1 more").arg(alarms.size() - 1) : QString());
  acknowledge_->setVisible(alarms_.needsAcknowledging());
  setAccessibleName(first == nullptr ? tr("No alarms")
                                     : tr("Alarm, %1: %2").arg(priority_->text(), text_->text()));
  const bool urgent = first != nullptr && first->active && !first->acknowledged &&
                      first->condition.priority == Priority::kHigh;
  flash_dark_ = false;
  if (urgent)
    flash_.start();
  else
    flash_.stop();
  paintGround();
}

void AlarmBar::paintGround() {
  const auto& alarms = alarms_.alarms();
  const Ground look = groundOf(alarms.isEmpty() ? nullptr : &alarms.first());
  const QColor ground = theme_.colour(QLatin1String(look.ground)).darker(flash_dark_ ? 160 : 100);
  const QColor text = theme_.colour(QLatin1String(look.text));
  setStyleSheet(QStringLiteral("#alarmBar { background: %1; border: 1px solid %2; border-radius: 8px; } "
                               "#alarmBar QLabel { color: %3; }")
                    .arg(ground.name(), theme_.colour(QStringLiteral("border")).name(), text.name()));
  sign_->setColour(text);
}

}  // namespace mirrorarm::ui
