#pragma once

#include <array>
#include <optional>

#include <QLabel>
#include <QWidget>

#include "ui/model/calibration_presenter.h"
#include "ui/model/standing_lines.h"
#include "ui/views/theme.h"

class QVBoxLayout;

namespace mirrorarm::ui {

class ActionButton;
class BoardForm;
class StatusLight;
class StepRail;

/// Where the calibration stands, what can be calibrated and how each stands, and the board.
class JobPanel : public QWidget {
  Q_OBJECT
 public:
  /// `presenter` outlives the panel.
  explicit JobPanel(CalibrationPresenter& presenter, QWidget* parent = nullptr);
  void setTheme(const Theme& theme);
  void show(const StandingLines& standing);
  using QWidget::show;

 private:
  struct Job {
    ActionButton* button;
    StatusLight* light;
    QLabel* standing;
  };
  void addJobs(QVBoxLayout& column);
  void addJob(QVBoxLayout& column, station::CalibrationJob job);
  void draw(const CalibrationState& state);

  CalibrationPresenter& presenter_;
  StepRail* rail_;
  std::array<Job, station::kCalibrationJobCount> jobs_{};
  BoardForm* board_;
};

}  // namespace mirrorarm::ui
