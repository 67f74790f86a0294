#include "ui/panels/action_button.h"

#include <QPainter>
#include <QStyleOptionButton>
#include <QVariant>

#include "ui/panels/text.h"

namespace mirrorarm::ui {
namespace {

constexpr int kKeyMargin_px = 10;
constexpr int kKeyFont_px = 11;

}  // namespace

ActionButton::ActionButton(const QString& objectName, const QString& text, const QKeySequence& key,
                           QWidget* parent)
    : QPushButton(text, parent), key_text_(key.toString(QKeySequence::NativeText)) {
  setObjectName(objectName);
  setAccessibleName(text);
  setShortcut(key);
  setToolTip(QStringLiteral("%1 (%2)").arg(text, key_text_));
  setCursor(Qt::PointingHandCursor);
}

// QPushButton takes the key of the new text, which is none.
void ActionButton::setWords(const QString& words) {
  if (words == text()) return;
  const QKeySequence key = shortcut();
  setText(words);
  setShortcut(key);
}

void ActionButton::setOn(const QString& words, bool on) {
  setChecked(on);
  setWords((on ? QStringLiteral("☑ ") : QStringLiteral("☐ ")) + words);
}

void ActionButton::setPrimary(bool primary) {
  if (property("primary").toBool() == primary) return;
  setProperty("primary", primary);
  restyle(*this);
}

QSize ActionButton::sizeHint() const {
  const int key_px = fontMetrics().horizontalAdvance(key_text_) + kKeyMargin_px;
  const bool left = property("quiet").toBool() || property("choice").toBool();
  const int sides = left ? 1 : 2;  // a centred text must not reach the key
  return QPushButton::sizeHint() + QSize(sides * key_px, 0);
}

void ActionButton::paintEvent(QPaintEvent* event) {
  QPushButton::paintEvent(event);
  QPainter painter(this);
  QFont font = painter.font();
  font.setPixelSize(kKeyFont_px);
  font.setBold(false);
  painter.setFont(font);
  QStyleOptionButton option;
  initStyleOption(&option);
  painter.setPen(option.palette.color(QPalette::ButtonText));
  painter.drawText(rect().adjusted(0, 0, -kKeyMargin_px, 0), Qt::AlignRight | Qt::AlignVCenter, key_text_);
}

}  // namespace mirrorarm::ui
