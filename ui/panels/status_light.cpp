#include "ui/panels/status_light.h"

#include <QPainter>

namespace mirrorarm::ui {
namespace {

constexpr int kSize_px = 30;

void drawTick(QPainter& painter, const QPointF& c) {
  painter.drawPolyline(
      QVector<QPointF>{c + QPointF(-6, 0.5), c + QPointF(-1.8, 4.7), c + QPointF(6.2, -4.5)});
}

void drawCross(QPainter& painter, const QPointF& c) {
  painter.drawLine(c + QPointF(-4.5, -4.5), c + QPointF(4.5, 4.5));
  painter.drawLine(c + QPointF(-4.5, 4.5), c + QPointF(4.5, -4.5));
}

void drawExclamation(QPainter& painter, const QPointF& c) {
  painter.drawLine(c + QPointF(0, -3.5), c + QPointF(0, 3.0));
  painter.drawPoint(c + QPointF(0, 7.2));
}

}  // namespace

StatusLight::StatusLight(QWidget* parent) : QWidget(parent) { setFixedSize(kSize_px, kSize_px); }

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
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor outline = theme_.colour(QStringLiteral("outline"));
  const QPointF centre = QRectF(rect()).center();
  const QRectF body = QRectF(rect()).adjusted(2, 2, -2, -2);
  const QPen sign(QColor(0x12, 0x18, 0x1d), 2.8, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
  painter.setPen(QPen(outline, 1.5));
  switch (light_) {
    case Light::kOff:
      painter.setBrush(Qt::NoBrush);
      painter.drawEllipse(body);
      return;
    case Light::kGood:
      painter.setBrush(theme_.colour(QStringLiteral("good")));
      painter.drawEllipse(body);
      painter.setPen(sign);
      return drawTick(painter, centre);
    case Light::kWaiting:
      painter.setBrush(theme_.colour(QStringLiteral("waiting")));
      painter.drawPolygon(
          QVector<QPointF>{QPointF(centre.x(), body.top()), body.bottomRight(), body.bottomLeft()});
      painter.setPen(sign);
      return drawExclamation(painter, centre + QPointF(0, 2));
    case Light::kBad:
      painter.setBrush(theme_.colour(QStringLiteral("bad")));
      painter.drawRoundedRect(body, 3, 3);
      painter.setPen(sign);
      return drawCross(painter, centre);
  }
}

}  // namespace mirrorarm::ui
