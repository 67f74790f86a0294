#pragma once

#include <QStringList>
#include <QWidget>

#include "ui/views/theme.h"

namespace mirrorarm::ui {

/// Steps from top to bottom: done, present, to come.
class StepRail : public QWidget {
  Q_OBJECT
 public:
  explicit StepRail(const QStringList& names, QWidget* parent = nullptr);
  void setTheme(const Theme& theme);
  /// From 0; those before it are done.
  void setStep(int step);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void drawStep(QPainter& painter, int index) const;

  Theme theme_;
  const QStringList names_;
  int step_ = 0;
};

}  // namespace mirrorarm::ui
