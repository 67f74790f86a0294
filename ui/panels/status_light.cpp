#include "ui/panels/status_light.h"

#include <QPainter>

namespace mirrorarm::ui {
namespace {

constexpr double kDrawn_px = 30.0;  // what the shapes below are drawn for

void drawTick(QPainter& painter) {
  painter.drawPolyline(QVector<QPointF>{{-6, 0.5}, {-1.8, 4.7}, {6.2, -4.5}});
}

void drawCross(QPainter& painter) {
  painter.drawLine(QPointF(-4.5, -4.5), QPointF(4.5, 4.5));
  painter.drawLine(QPointF(-4.5, 4.5), QPointF(4.5, -4.5));
}

void drawExclamation(QPainter& painter) {
  painter.drawLine(QPointF(0, -1.5), QPointF(0, 5.0));
  painter.drawPoint(QPointF(0, 9.2));
}

/// The shape, and what is drawn over it.
void drawBody(QPainter& painter, const QRectF& body, Light light, const Theme& theme) {
  switch (light) {
    case Light::kOff:
      return painter.drawEllipse(body);
    case Light::kGood:
      painter.setBrush(theme.colour(QStringLiteral("good")));
      return painter.drawEllipse(body);
    case Light::kWaiting:
      painter.setBrush(theme.colour(QStringLiteral("waiting")));
      return painter.drawPolygon(QVector<QPointF>{{0, body.top()}, body.bottomRight(), body.bottomLeft()});
    case Light::kBad:
      painter.setBrush(theme.colour(QStringLiteral("bad")));
      return painter.drawRoundedRect(body, 3, 3);
  }
}

void drawSign(QPainter& painter, Light light) {
  switch (light) {
    case Light::kOff:
      return;
    case Light::kGood:
      return drawTick(painter);
    case Light::kWaiting:
      return drawExclamation(painter);
    case Light::kBad:
      return drawCross(painter);
  }
}

}  // namespace

void drawLight(QPainter& painter, const QRectF& place, Light light, const Theme& theme) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.translate(place.center());
  painter.scale(place.width() / kDrawn_px, place.width() / kDrawn_px);
  painter.setPen(QPen(theme.colour(QStringLiteral("outline")), 1.5));
  painter.setBrush(Qt::NoBrush);
  drawBody(painter, QRectF(-13, -13, 26, 26), light, theme);
  painter.setPen(QPen(QColor(0x12, 0x18, 0x1d), 2.8, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  drawSign(painter, light);
  painter.restore();
}

StatusLight::StatusLight(int size_px, QWidget* parent) : QWidget(parent) { setFixedSize(size_px, size_px); }

void StatusLight::setTheme(const Theme& theme) {
  theme_ = theme;
  update();
}

void StatusLight::setLight(Light light) {
  if (light == light_) return;
  light_ = light;
  update();
}

void StatusLight::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  drawLight(painter, rect(), light_, theme_);
}

}  // namespace mirrorarm::ui
