#pragma once

#include <QWidget>

#include "core/calibration/coverage.h"
#include "ui/views/theme.h"

namespace mirrorarm::ui {

/// How many views there are of each tilt and distance.
class CoverageMatrix : public QWidget {
  Q_OBJECT
 public:
  explicit CoverageMatrix(QWidget* parent = nullptr);
  void setTheme(const Theme& theme);
  void show(const calibration::Coverage& coverage);
  using QWidget::show;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  using Views = decltype(calibration::Coverage::pose);
  void drawCell(QPainter& painter, const QRectF& cell, int views) const;

  Theme theme_;
  Views views_{};
};

}  // namespace mirrorarm::ui
