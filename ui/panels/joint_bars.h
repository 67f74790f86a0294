#pragma once

#include <QWidget>

#include "ui/model/robot_presenter.h"
#include "ui/views/theme.h"

namespace mirrorarm::ui {

/// For each joint its place between its limits and its speed against what is allowed.
class JointBars : public QWidget {
  Q_OBJECT
 public:
  explicit JointBars(QWidget* parent = nullptr);
  void setTheme(const Theme& theme);
  void setJoints(const std::vector<JointFigures>& joints);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void drawCaptions(QPainter& painter) const;
  void drawJoint(QPainter& painter, const JointFigures& joint, double top) const;
  [[nodiscard]] QRectF placeTrack(double top) const;
  [[nodiscard]] QRectF speedTrack(double top) const;

  Theme theme_;
  std::vector<JointFigures> joints_;
};

}  // namespace mirrorarm::ui
