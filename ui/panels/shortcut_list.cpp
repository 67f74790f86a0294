#include "ui/panels/shortcut_list.h"

#include <QAbstractButton>
#include <QGridLayout>
#include <QVariant>

#include "ui/panels/text.h"

namespace mirrorarm::ui {

ShortcutList::ShortcutList(QWidget& window) : QDialog(&window) {
  setObjectName(QStringLiteral("shortcutList"));
  setWindowTitle(tr("Keys"));
  setAttribute(Qt::WA_DeleteOnClose);
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(20, 16, 20, 16);
  grid->setHorizontalSpacing(24);
  const auto add = [grid](const QString& key, const QString& what) {
    const int row = grid->rowCount();
    grid->addWidget(makeText("figure", key), row, 0);
    grid->addWidget(new QLabel(what), row, 1);
  };
  add(tr("Esc"), tr("STOP"));
  for (const auto* button : window.findChildren<QAbstractButton*>()) {
    const QString held = button->isVisible() ? button->property("heldKey").toString() : QString();
    if (!held.isEmpty()) add(held, button->accessibleName());
    if (!button->shortcut().isEmpty())
      add(button->shortcut().toString(QKeySequence::NativeText), button->accessibleName());
  }
}

}  // namespace mirrorarm::ui
