#pragma once

#include <QFrame>
#include <QLabel>
#include <QTimer>

#include "ui/model/alarm_list.h"
#include "ui/views/theme.h"

namespace mirrorarm::ui {

class ActionButton;
class PrioritySign;

/// The most urgent alarm, how many more there are, and the key to acknowledge them. A high alarm that nobody
/// has acknowledged flashes at 2 Hz (IEC 60601-1-8: 1.4 to 2.8 Hz).
class AlarmBar : public QFrame {
  Q_OBJECT
 public:
  /// `alarms` outlives the bar.
  explicit AlarmBar(AlarmList& alarms, QWidget* parent = nullptr);
  void setTheme(const Theme& theme);

 private:
  void draw();
  void paintGround();

  AlarmList& alarms_;
  Theme theme_;
  PrioritySign* sign_;
  QLabel* priority_;
  QLabel* text_;
  QLabel* more_;
  ActionButton* acknowledge_;
  QTimer flash_;
  bool flash_dark_ = false;
};

}  // namespace mirrorarm::ui
