#pragma once

#include <QVector>
#include <QWidget>

#include "ui/model/motion_trace.h"
#include "ui/views/theme.h"

class QCPAxisRect;
class QCPGraph;
class QCPTextElement;
class QCustomPlot;

namespace mirrorarm::ui {

/// The last seconds: how far both arms are from where they were aligned, below how far the sling is from its
/// goal.
class MotionPlot : public QWidget {
  Q_OBJECT
 public:
  /// `window_s`: how much the time axis shows.
  explicit MotionPlot(double window_s, QWidget* parent = nullptr);
  void setTheme(const Theme& theme);
  void show(const MotionTrace& trace);
  using QWidget::show;

 private:
  void setUpAxes(QCPAxisRect& rect, double window_s);
  void paintAxes(QCPAxisRect& rect, const Theme& theme);
  static void fitHeight(QCPAxisRect& rect, double smallest);

  QCustomPlot* plot_;
  QCPAxisRect* displacement_;
  QCPAxisRect* distance_;
  QCPGraph* healthy_;
  QCPGraph* impaired_;
  QCPGraph* to_goal_;
};

}  // namespace mirrorarm::ui
