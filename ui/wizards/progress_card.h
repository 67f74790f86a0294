#pragma once

#include <QFrame>
#include <QLabel>
#include <QProgressBar>

#include "ui/model/calibration_presenter.h"

namespace mirrorarm::ui {

/// How far it has come, and why the last wish was refused.
class ProgressCard : public QFrame {
  Q_OBJECT
 public:
  explicit ProgressCard(QWidget* parent = nullptr);
  void show(const CalibrationState& state);
  using QFrame::show;

 private:
  QLabel* what_;
  QProgressBar* bar_;
  QLabel* message_;
};

}  // namespace mirrorarm::ui
