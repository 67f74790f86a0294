#include "ui/panels/step_rail.h"

#include <QPainter>

namespace mirrorarm::ui {
namespace {

constexpr int kRow_px = 38;
constexpr double kRadius_px = 12.0;
constexpr double kCentre_px = 24.0;  // of the circles, from the left

}  // namespace

StepRail::StepRail(const QStringList& names, QWidget* parent) : QWidget(parent), names_(names) {
  setObjectName(QStringLiteral("stepRail"));
  setFixedHeight(names_.size() * kRow_px);
  setStep(step_);
}

void StepRail::setTheme(const Theme& theme) {
  theme_ = theme;
  update();
}

void StepRail::setStep(int step) {
  step_ = step;
  setAccessibleName(tr("Step %1 of %2: %3").arg(step + 1).arg(names_.size()).arg(names_.at(step)));
  update();
}

void StepRail::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(theme_.colour(QStringLiteral("border_strong")), 1.5));
  for (int index = 0; index + 1 < names_.size(); ++index) {
    const double middle = (index + 0.5) * kRow_px;
    painter.drawLine(QPointF(kCentre_px, middle + kRadius_px),
                     QPointF(kCentre_px, middle + kRow_px - kRadius_px));
  }
  for (int index = 0; index < names_.size(); ++index) drawStep(painter, index);
}

void StepRail::drawStep(QPainter& painter, int index) const {
  const bool done = index < step_;
  const bool present = index == step_;
  const QRectF row(0, index * kRow_px, width(), kRow_px);
  const QPointF centre(kCentre_px, row.center().y());
  if (present) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme_.colour(QStringLiteral("accent_soft")));
    painter.drawRoundedRect(row.adjusted(2, 2, -2, -2), 6, 6);
  }
  const QColor accent = theme_.colour(QStringLiteral("accent"));
  painter.setPen(QPen(done || present ? accent : theme_.colour(QStringLiteral("border_strong")), 1.8));
  painter.setBrush(present ? accent : theme_.colour(QStringLiteral("surface")));
  painter.drawEllipse(centre, kRadius_px, kRadius_px);
  QFont font = painter.font();
  font.setPixelSize(present ? 15 : 14);
  font.setBold(present);
  painter.setFont(font);
  painter.setPen(theme_.colour(QLatin1String(present || done ? "text" : "text_muted")));
  painter.drawText(row.adjusted(kCentre_px + kRadius_px + 12, 0, 0, 0), Qt::AlignVCenter, names_.at(index));
  painter.setPen(QPen(present ? theme_.colour(QStringLiteral("on_accent"))
                      : done  ? accent
                              : theme_.colour(QStringLiteral("text_muted")),
                      2.2));
  if (done) {
    painter.drawPolyline(
        QVector<QPointF>{centre + QPointF(-5, 0.5), centre + QPointF(-1.5, 4), centre + QPointF(5.2, -3.8)});
    return;
  }
  font.setPixelSize(13);
  font.setBold(true);
  painter.setFont(font);
  painter.drawText(QRectF(centre - QPointF(kRadius_px, kRadius_px), QSizeF(2 * kRadius_px, 2 * kRadius_px)),
                   Qt::AlignCenter, QString::number(index + 1));
}

}  // namespace mirrorarm::ui
