#pragma once

#include <array>
#include <optional>

#include <QMainWindow>

#include "core/station/station_port.h"
#include "ui/model/alarm_list.h"
#include "ui/model/help_presenter.h"
#include "ui/model/journal.h"
#include "ui/model/live_feed.h"
#include "ui/model/log_model.h"
#include "ui/model/motion_trace.h"
#include "ui/model/report_job.h"
#include "ui/model/robot_presenter.h"
#include "ui/model/session_presenter.h"
#include "ui/model/tracking_presenter.h"
#include "ui/model/workplace.h"
#include "ui/views/theme.h"

class QVBoxLayout;

namespace mirrorarm::ui {

class AlarmBar;
class HeaderBar;
class QualityPanel;
class RobotPanel;
class SceneView;
class SessionPanel;
class StepRail;
class StereoImageView;

/// The workstation's one window. Owns the presenters and hands every snapshot round at the feed's beat.
class MainWindow : public QMainWindow {
  Q_OBJECT
 public:
  /// `port` outlives the window; `read_report` is called on a worker.
  MainWindow(station::StationPort& port, Workplace workplace, Themes themes, ReportJob::Read read_report);
  ~MainWindow() override;

  void setDark(bool dark);
  [[nodiscard]] bool isDark() const { return dark_; }
  /// Starts the beat.
  void start();
  [[nodiscard]] LiveFeed& feed() { return feed_; }
  [[nodiscard]] SessionPresenter& session() { return session_; }

 signals:
  /// The devices are wanted for calibrating; there is no session.
  void calibrationWanted();

 private:
  [[nodiscard]] QWidget* makeLeft();
  [[nodiscard]] QWidget* makeMiddle();
  [[nodiscard]] QWidget* makeRight();
  [[nodiscard]] QWidget* makeBottom();
  void join();
  void present(const station::Snapshot& snapshot, TimePoint now);
  void enlargeImages();

  const Workplace workplace_;
  const Themes themes_;
  bool dark_ = false;
  bool images_large_ = false;
  int beat_ = 0;

  LiveFeed feed_;
  SessionPresenter session_;
  TrackingPresenter tracking_;
  HelpPresenter help_;
  RobotPresenter robot_;
  MotionTrace trace_;
  AlarmList alarms_;
  LogModel log_;
  Journal journal_;
  ReportJob report_;

  HeaderBar* header_;
  StepRail* rail_;
  SessionPanel* session_panel_;
  SceneView* scene_;
  StereoImageView* images_;
  QualityPanel* quality_panel_;
  RobotPanel* robot_panel_;
  AlarmBar* alarm_bar_;
};

}  // namespace mirrorarm::ui
