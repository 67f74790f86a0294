#pragma once

#include <QLabel>

#include "core/station/snapshot.h"
#include "ui/panels/header_frame.h"

namespace mirrorarm::ui {

/// The top line of the session's window: the session and whether it is recorded.
class HeaderBar : public HeaderFrame {
  Q_OBJECT
 public:
  explicit HeaderBar(bool simulated, QWidget* parent = nullptr);
  void show(const station::RecordState& record);
  using QFrame::show;
  /// Calibrating takes the devices away from the session: only before one begins.
  void setCalibrationAllowed(bool allowed);

 signals:
  void viewWanted();    ///< the scene from where everything is seen
  void imagesWanted();  ///< the camera images large or small
  void calibrationWanted();
  void themeWanted();
  void keysWanted();

 private:
  ActionButton* add(const char* name, const QString& text, const QString& key, void (HeaderBar::*wanted)());

  QLabel* session_;
  QLabel* recording_;
  ActionButton* calibrate_ = nullptr;
};

}  // namespace mirrorarm::ui
