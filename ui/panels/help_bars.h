#pragma once

#include <QWidget>

#include "ui/model/robot_presenter.h"
#include "ui/views/theme.h"

namespace mirrorarm::ui {

/// The force at the sling against what the plan allows, and how much the robot helps: two bars in a row.
class HelpBars : public QWidget {
  Q_OBJECT
 public:
  explicit HelpBars(QWidget* parent = nullptr);
  void setTheme(const Theme& theme);
  void setFigures(const RobotFigures& figures);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  struct Bar {
    QString name;
    QString value;
    double share = 0.0;
    QString colour;
    bool bold = false;
  };
  void draw(QPainter& painter, const Bar& bar, int place) const;

  Theme theme_;
  RobotFigures figures_;
};

}  // namespace mirrorarm::ui
