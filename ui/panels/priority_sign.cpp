#include "ui/panels/priority_sign.h"

#include <QPainter>

namespace mirrorarm::ui {
namespace {

constexpr int kSize_px = 26;

void drawStrokes(QPainter& painter, const QPointF& centre, int count) {
  for (int i = 0; i < count; ++i) {
    const double x = centre.x() + (i - (count - 1) / 2.0) * 4.6;
    painter.drawLine(QPointF(x, centre.y() - 4), QPointF(x, centre.y() + 1.5));
    painter.drawPoint(QPointF(x, centre.y() + 5));
  }
}

}  // namespace

PrioritySign::PrioritySign(QWidget* parent) : QWidget(parent) { setFixedSize(kSize_px + 4, kSize_px); }

void PrioritySign::setPriority(std::optional<Priority> priority) {
  priority_ = priority;
  update();
}

void PrioritySign::setColour(const QColor& colour) {
  colour_ = colour;
  update();
}

void PrioritySign::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(colour_, 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  const QRectF body = QRectF(rect()).adjusted(2, 2, -2, -2);
  const QPointF centre = body.center();
  if (!priority_) {
    painter.drawPolyline(
        QVector<QPointF>{centre + QPointF(-6, 0.5), centre + QPointF(-2, 4.5), centre + QPointF(6, -4.5)});
    return;
  }
  if (*priority_ == Priority::kLow)
    painter.drawEllipse(centre, body.height() / 2, body.height() / 2);
  else
    painter.drawPolygon(
        QVector<QPointF>{QPointF(centre.x(), body.top()), body.bottomRight(), body.bottomLeft()});
  const QPointF strokes = *priority_ == Priority::kLow ? centre : centre + QPointF(0, 4);
  drawStrokes(painter, strokes, static_cast<int>(*priority_) + 1);
}

}  // namespace mirrorarm::ui
