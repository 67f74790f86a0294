#pragma once

#include <QPushButton>
#include <QTimer>

#include "core/control/enabling_switch.h"

namespace mirrorarm::ui {

/// The enabling device on the screen: held with the mouse, or as a key, which pedals send too. F11 is the
/// middle position; Shift with it, or Pause, as a pedal's end stop sends, is pressed through. Says its
/// position again and again, and that it is released when the window is left.
class EnablingButton : public QPushButton {
  Q_OBJECT
 public:
  explicit EnablingButton(QWidget* parent = nullptr);
  ~EnablingButton() override;

  /// What the station says counts.
  void show(control::EnablingPosition counted);
  using QWidget::show;

 signals:
  void said(mirrorarm::control::EnablingPosition position);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  [[nodiscard]] control::EnablingPosition position() const;
  void say();
  bool key_held_ = false;
  bool end_held_ = false;
  bool shift_held_ = false;
  QTimer beat_;
};

}  // namespace mirrorarm::ui
