#pragma once

#include <array>

#include <QFrame>
#include <QLabel>

#include "ui/model/tracking_presenter.h"
#include "ui/views/theme.h"

namespace mirrorarm::ui {

class Figure;
class MotionPlot;
class MotionTrace;
class StatusLight;

/// How well the healthy arm is seen, and how both arms have moved lately.
class QualityPanel : public QWidget {
  Q_OBJECT
 public:
  explicit QualityPanel(QWidget* parent = nullptr);
  void setTheme(const Theme& theme);
  void show(const TrackingState& state);
  void show(const MotionTrace& trace);
  using QWidget::show;

 private:
  [[nodiscard]] QWidget* makeStatusRow();
  [[nodiscard]] QWidget* makeFigures();
  [[nodiscard]] QWidget* makeExposure();

  StatusLight* light_;
  QLabel* status_;
  QLabel* detail_;
  Figure* markers_;
  Figure* misfit_;
  Figure* age_;
  Figure* computing_;
  Figure* lost_frames_;
  Figure* refused_;
  std::array<QLabel*, 2> exposure_;
  QLabel* legend_;
  MotionPlot* plot_;
};

}  // namespace mirrorarm::ui
