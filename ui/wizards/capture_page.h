#pragma once

#include <QTableView>
#include <QWidget>

#include "ui/model/calibration_presenter.h"
#include "ui/model/view_list.h"
#include "ui/views/theme.h"

namespace mirrorarm::ui {

class ActionButton;
class BoardImageView;
class CoverageMatrix;

/// What the cameras see, what has been covered, and the views that were taken.
class CapturePage : public QWidget {
  Q_OBJECT
 public:
  /// Both outlive the page.
  CapturePage(CalibrationPresenter& presenter, ViewList& views, QWidget* parent = nullptr);
  void setTheme(const Theme& theme);
  /// `rig`: what the proposal is drawn by.
  void show(const station::CalibrationSnapshot& snapshot, const std::optional<camera::StereoRig>& rig);
  using QWidget::show;

 private:
  [[nodiscard]] QWidget* makeCoverage();
  [[nodiscard]] QWidget* makeViews();
  void enableButtons();
  void removeChosen();

  CalibrationPresenter& presenter_;
  BoardImageView* images_;
  CoverageMatrix* matrix_;
  QTableView* table_;
  ActionButton* remove_;
  ActionButton* undo_;
};

}  // namespace mirrorarm::ui
