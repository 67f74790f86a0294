#pragma once

#include <optional>

#include <QWidget>

#include "ui/model/alarm_rules.h"

namespace mirrorarm::ui {

/// The sign of an alarm's priority by shape: three strokes in a triangle for high, two for medium, one in a
/// disc for low, a tick when there is no alarm. Drawn in the text's colour.
class PrioritySign : public QWidget {
  Q_OBJECT
 public:
  explicit PrioritySign(QWidget* parent = nullptr);
  void setPriority(std::optional<Priority> priority);
  void setColour(const QColor& colour);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::optional<Priority> priority_;
  QColor colour_;
};

}  // namespace mirrorarm::ui
