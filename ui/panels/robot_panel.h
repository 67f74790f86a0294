#pragma once

#include <QLabel>

#include "ui/model/help_presenter.h"
#include "ui/model/robot_presenter.h"
#include "ui/views/theme.h"

namespace mirrorarm::ui {

class Figure;
class HelpBars;
class JointBars;

/// What the robot does, against what it may do.
class RobotPanel : public QWidget {
  Q_OBJECT
 public:
  /// `help` outlives the panel.
  explicit RobotPanel(HelpPresenter& help, QWidget* parent = nullptr);
  void setTheme(const Theme& theme);
  void show(const RobotFigures& figures);
  using QWidget::show;

 private:
  QLabel* motion_;
  HelpBars* help_;
  JointBars* joints_;
  Figure* tool_speed_;
  Figure* lag_;
  Figure* way_;
  Figure* guard_;
};

}  // namespace mirrorarm::ui
