#include "ui/panels/enabling_button.h"

#include <QApplication>
#include <QKeyEvent>

#include "ui/model/words.h"
#include "ui/panels/text.h"

namespace mirrorarm::ui {
namespace {

using control::EnablingPosition;

constexpr int kBeat_ms = 40;  // the station bears silence for a quarter of a second
constexpr Qt::Key kMiddle = Qt::Key_F11, kEnd = Qt::Key_Pause;

}  // namespace

EnablingButton::EnablingButton(QWidget* parent) : QPushButton(parent) {
  setObjectName(QStringLiteral("enablingButton"));
  setAccessibleName(tr("Hold to enable motion"));
  setToolTip(tr("Hold to enable motion (F11). Letting go or pressing through (Pause) stops the robot."));
  setProperty("heldKey", QStringLiteral("F11"));
  setFocusPolicy(Qt::NoFocus);
  setProperty("quiet", true);
  show(EnablingPosition::kReleased);
  connect(this, &QPushButton::pressed, this, &EnablingButton::say);
  connect(this, &QPushButton::released, this, &EnablingButton::say);
  connect(&beat_, &QTimer::timeout, this, &EnablingButton::say);
  beat_.start(kBeat_ms);
  qApp->installEventFilter(this);
}

EnablingButton::~EnablingButton() { qApp->removeEventFilter(this); }

void EnablingButton::show(EnablingPosition counted) {
  const QString words_now = counted == EnablingPosition::kReleased ? tr("Hold to enable (F11)")
                                                                   : tr("%1 (F11)").arg(words(counted));
  if (words_now == text()) return;
  setText(words_now);
  setProperty("primary", counted == EnablingPosition::kEnabled);
  restyle(*this);
}

EnablingPosition EnablingButton::position() const {
  if (end_held_ || (key_held_ && shift_held_)) return EnablingPosition::kPressedThrough;
  return key_held_ || isDown() ? EnablingPosition::kEnabled : EnablingPosition::kReleased;
}

void EnablingButton::say() { emit said(position()); }

// Seen before any widget takes the key. A key that is let go while another window has it is never told.
bool EnablingButton::eventFilter(QObject* watched, QEvent* event) {
  const bool down = event->type() == QEvent::KeyPress;
  if (down || event->type() == QEvent::KeyRelease) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if (!key->isAutoRepeat() &&
        (key->key() == kMiddle || key->key() == kEnd || key->key() == Qt::Key_Shift)) {
      (key->key() == kMiddle ? key_held_ : key->key() == kEnd ? end_held_ : shift_held_) = down;
      say();
    }
  } else if (event->type() == QEvent::ApplicationDeactivate || event->type() == QEvent::WindowDeactivate) {
    key_held_ = end_held_ = shift_held_ = false;
    setDown(false);
    say();
  }
  return QPushButton::eventFilter(watched, event);
}

}  // namespace mirrorarm::ui
