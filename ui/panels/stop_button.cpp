#include "ui/panels/stop_button.h"

#include <QApplication>
#include <QKeyEvent>
#include <QPainter>

namespace mirrorarm::ui {

StopButton::StopButton(QWidget* parent) : QPushButton(QStringLiteral("STOP"), parent) {
  setObjectName(QStringLiteral("stopButton"));
  setAccessibleName(tr("STOP"));
  setAccessibleDescription(tr("Brings the robot to rest at once. Escape key."));
  setToolTip(tr("Brings the robot to rest at once (Esc)"));
  setMinimumHeight(kSmallestHeight_px);
  setCursor(Qt::PointingHandCursor);
  connect(this, &QPushButton::pressed, this, &StopButton::stopWanted);
  qApp->installEventFilter(this);
}

StopButton::~StopButton() { qApp->removeEventFilter(this); }

// A shortcut would be silent while a dialog is open or when two widgets claim the key; a stop must not be.
bool StopButton::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::KeyPress && watched->isWidgetType()) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->key() == Qt::Key_Escape && !key->isAutoRepeat()) emit stopWanted();
  }
  return QPushButton::eventFilter(watched, event);
}

void StopButton::paintEvent(QPaintEvent* event) {
  QPushButton::paintEvent(event);
  QPainter painter(this);
  QFont font = painter.font();
  font.setPixelSize(12);
  font.setBold(false);
  font.setLetterSpacing(QFont::AbsoluteSpacing, 0);
  painter.setFont(font);
  painter.setPen(palette().color(QPalette::ButtonText));
  painter.drawText(rect().adjusted(0, 0, 0, -10), Qt::AlignHCenter | Qt::AlignBottom, tr("Esc"));
}

}  // namespace mirrorarm::ui
