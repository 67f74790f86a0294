#pragma once

#include <QWidget>

#include "ui/model/session_presenter.h"
#include "ui/views/theme.h"

namespace mirrorarm::ui {

/// The steps of a session from top to bottom: done, present, to come.
class StepRail : public QWidget {
  Q_OBJECT
 public:
  explicit StepRail(QWidget* parent = nullptr);
  void setTheme(const Theme& theme);
  void setStep(Step step);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void drawStep(QPainter& painter, int index) const;

  Theme theme_;
  Step step_ = Step::kPrepare;
};

}  // namespace mirrorarm::ui
