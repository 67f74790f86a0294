#pragma once

#include <QDialog>

namespace mirrorarm::ui {

/// The list of every key, gathered from the buttons of `window`, so that it cannot be out of date. Does not
/// block the window behind it.
class ShortcutList : public QDialog {
  Q_OBJECT
 public:
  explicit ShortcutList(QWidget& window);
};

}  // namespace mirrorarm::ui
