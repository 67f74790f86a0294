#pragma once

#include <vector>

#include <QColor>
#include <QRectF>
#include <QString>

#include "ui/report/report_contents.h"

class QCPPainter;

namespace mirrorarm::ui::report {

/// One line of a chart over the chart's times.
struct Course {
  QString name;
  QColor colour;
  const std::vector<double>* values = nullptr;  ///< NaN breaks the line
};

/// One of the stacked axes of a chart.
struct Panel {
  QString label;  ///< what and in which unit
  std::vector<Course> courses;
  bool from_zero = false;
};

/// Stacked panels over one time axis, with the rests shaded and the stops marked.
struct CourseChart {
  QString title;
  const std::vector<double>* time_s = nullptr;
  TimeSpan span;
  std::vector<TimeSpan> rests;
  std::vector<double> stops_s;
  std::vector<Panel> panels;
  double least_range = 0.0;  ///< smallest height of an axis, so that noise does not look like movement
  bool equal_scale = false;  ///< all panels show as many units in the same height
};

/// Draws title, legend and panels as vectors. GUI thread: a QCustomPlot is a widget, though never shown.
void draw(const CourseChart& chart, QCPPainter& painter, const QRectF& place);

}  // namespace mirrorarm::ui::report
