#pragma once

#include <array>

#include <QLabel>
#include <QTableView>
#include <QWidget>

#include "ui/model/calibration_presenter.h"
#include "ui/model/view_list.h"
#include "ui/views/theme.h"

class QVBoxLayout;

namespace mirrorarm::ui {

class ActionButton;
class EnablingButton;
class LightsList;

/// What to do now, how the view and the views stand, and what may be pressed.
class GuidePanel : public QWidget {
  Q_OBJECT
 public:
  /// Both outlive the panel.
  GuidePanel(CalibrationPresenter& presenter, ViewList& views, QWidget* parent = nullptr);
  void setTheme(const Theme& theme);

 private:
  void addToggles(QVBoxLayout& column);
  void addActions(QVBoxLayout& column);
  [[nodiscard]] QWidget* makeResiduals(ViewList& views);
  void draw(const CalibrationState& state);
  void drawActions(const CalibrationState& state);
  void moveFocus(const CalibrationState& state);

  CalibrationPresenter& presenter_;
  QLabel* title_;
  QLabel* instruction_;
  LightsList* lights_;
  std::array<ActionButton*, kCalibrationActionCount> actions_{};  ///< null: has its place elsewhere
  ActionButton* reset_;
  EnablingButton* enabling_;
  QWidget* residuals_;
  station::CalibrationPhase phase_ = station::CalibrationPhase::kIdle;
};

}  // namespace mirrorarm::ui
