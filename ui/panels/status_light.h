#pragma once

#include <QWidget>

#include "ui/model/light.h"
#include "ui/views/theme.h"

namespace mirrorarm::ui {

/// Fills `place`, a square: a disc with a tick, a triangle, a square with a cross, an empty ring.
void drawLight(QPainter& painter, const QRectF& place, Light light, const Theme& theme);

/// A status by shape and colour.
class StatusLight : public QWidget {
  Q_OBJECT
 public:
  static constexpr int kLarge_px = 30;
  static constexpr int kSmall_px = 18;

  explicit StatusLight(int size_px = kLarge_px, QWidget* parent = nullptr);
  void setTheme(const Theme& theme);
  void setLight(Light light);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Theme theme_;
  Light light_ = Light::kOff;
};

}  // namespace mirrorarm::ui
