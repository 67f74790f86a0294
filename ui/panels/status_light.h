#pragma once

#include <QWidget>

#include "ui/model/tracking_presenter.h"
#include "ui/views/theme.h"

namespace mirrorarm::ui {

/// A status by shape and colour: a disc with a tick, a triangle, a square with a cross, an empty ring.
class StatusLight : public QWidget {
  Q_OBJECT
 public:
  explicit StatusLight(QWidget* parent = nullptr);
  void setTheme(const Theme& theme);
  void setLight(Light light);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Theme theme_;
  Light light_ = Light::kOff;
};

}  // namespace mirrorarm::ui
