#pragma once

#include <QFrame>
#include <QListView>

#include "ui/model/log_model.h"

namespace mirrorarm::ui {

/// What happened, the newest line always in sight.
class LogPanel : public QFrame {
  Q_OBJECT
 public:
  /// `log` outlives the panel.
  explicit LogPanel(LogModel& log, QWidget* parent = nullptr);

 private:
  QListView* lines_;
};

}  // namespace mirrorarm::ui
