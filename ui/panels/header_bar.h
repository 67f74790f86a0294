#pragma once

#include <QFrame>
#include <QKeySequence>
#include <QLabel>

#include "core/station/snapshot.h"

class QHBoxLayout;

namespace mirrorarm::ui {

/// The top line: the product, the session, whether it is recorded, and for good whether this is a simulation.
class HeaderBar : public QFrame {
  Q_OBJECT
 public:
  explicit HeaderBar(bool simulated, QWidget* parent = nullptr);
  void show(const station::RecordState& record);
  using QFrame::show;

 signals:
  void viewWanted();    ///< the scene from where everything is seen
  void imagesWanted();  ///< the camera images large or small
  void themeWanted();
  void keysWanted();

 private:
  void add(QHBoxLayout& row, const char* name, const QString& text, const QKeySequence& key,
           void (HeaderBar::*wanted)());

  QLabel* session_;
  QLabel* recording_;
};

}  // namespace mirrorarm::ui
