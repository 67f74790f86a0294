#pragma once

#include <functional>
#include <optional>

#include <QMainWindow>
#include <QTimer>

#include "core/camera/stereo_rig.h"
#include "core/station/calibration_port.h"
#include "ui/model/calibration_presenter.h"
#include "ui/model/standing_lines.h"
#include "ui/model/view_list.h"
#include "ui/views/theme.h"

class QStackedWidget;

namespace mirrorarm::ui {

class CapturePage;
class GuidePanel;
class JobPanel;
class ProgressCard;
class ResultPage;

/// What the wizards know of the equipment: values copied once, no device.
struct CalibrationDesk {
  calibration::Board board;  ///< proposed
  bool simulated = false;
};

/// What the wizards show of the calibrations in force.
struct InForceView {
  StandingLines standing;
  std::optional<camera::StereoRig> rig;  ///< as far as it is known: proposals are drawn by it
};

/// The calibration wizards' window. Owns the presenter and hands every snapshot round at its own beat.
class CalibrationWindow : public QMainWindow {
  Q_OBJECT
 public:
  /// Asked at the start and whenever one was accepted.
  using ReadInForce = std::function<InForceView()>;

  /// `port` outlives the window.
  CalibrationWindow(station::CalibrationPort& port, CalibrationDesk desk, Themes themes,
                    ReadInForce read_in_force);
  ~CalibrationWindow() override;

  void setDark(bool dark);
  [[nodiscard]] bool isDark() const { return dark_; }
  /// Starts the beat.
  void start();
  /// One beat at once.
  void take();
  [[nodiscard]] CalibrationPresenter& presenter() { return presenter_; }

 signals:
  /// The devices are free for a session again.
  void sessionWanted();

 private:
  [[nodiscard]] QWidget* makeHeader();
  [[nodiscard]] QWidget* makeBottom();
  void join();
  void draw(const CalibrationState& state);
  void readInForce();

  station::CalibrationPort& port_;
  const CalibrationDesk desk_;
  const Themes themes_;
  const ReadInForce read_in_force_;
  InForceView in_force_;
  bool dark_ = false;
  station::CalibrationPhase phase_ = station::CalibrationPhase::kIdle;
  QTimer timer_;

  CalibrationPresenter presenter_;
  ViewList views_;

  JobPanel* jobs_;
  CapturePage* capture_;
  ResultPage* result_;
  QStackedWidget* pages_;
  GuidePanel* guide_;
  ProgressCard* progress_;
};

}  // namespace mirrorarm::ui
