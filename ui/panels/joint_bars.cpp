#include "ui/panels/joint_bars.h"

#include <cmath>

#include <QPainter>

namespace mirrorarm::ui {
namespace {

constexpr int kCaption_px = 14;
constexpr int kRow_px = 13;
constexpr double kName_px = 30, kAngle_px = 62, kSpeed_px = 76, kGap_px = 14;
constexpr double kTrack_px = 6;

}  // namespace

JointBars::JointBars(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("jointBars"));
  setAccessibleName(tr("Joints against their limits"));
  setFixedHeight(kCaption_px + 7 * kRow_px);
}

void JointBars::setTheme(const Theme& theme) {
  theme_ = theme;
  update();
}

void JointBars::setJoints(const std::vector<JointFigures>& joints) {
  if (joints.size() != joints_.size())
    setFixedHeight(kCaption_px + static_cast<int>(joints.size()) * kRow_px);
  joints_ = joints;
  update();
}

QRectF JointBars::placeTrack(double top) const {
  const double left = kName_px;
  const double right = width() - kAngle_px - kSpeed_px - kGap_px;
  return {left, top + (kRow_px - kTrack_px) / 2, right - left, kTrack_px};
}

QRectF JointBars::speedTrack(double top) const {
  return {width() - kSpeed_px, top + (kRow_px - kTrack_px) / 2, kSpeed_px, kTrack_px};
}

void JointBars::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  drawCaptions(painter);
  double top = kCaption_px;
  for (const auto& joint : joints_) {
    drawJoint(painter, joint, top);
    top += kRow_px;
  }
}

void JointBars::drawCaptions(QPainter& painter) const {
  QFont font = painter.font();
  font.setPixelSize(11);
  painter.setFont(font);
  painter.setPen(theme_.colour(QStringLiteral("text_muted")));
  const QRectF line(0, 0, width(), kCaption_px);
  painter.drawText(line.adjusted(kName_px, 0, 0, 0), Qt::AlignVCenter | Qt::AlignLeft, tr("Place in range"));
  painter.drawText(line, Qt::AlignVCenter | Qt::AlignRight, tr("Speed / limit"));
}

void JointBars::drawJoint(QPainter& painter, const JointFigures& joint, double top) const {
  const QRectF row(0, top, width(), kRow_px);
  const QRectF place = placeTrack(top);
  const QRectF speed = speedTrack(top);
  QFont font = painter.font();
  font.setPixelSize(12);
  font.setBold(joint.near_limit);
  painter.setFont(font);
  painter.setPen(theme_.colour(QStringLiteral("text")));
  painter.drawText(row, Qt::AlignVCenter | Qt::AlignLeft, joint.name);
  painter.drawText(QRectF(place.right(), top, kAngle_px, kRow_px), Qt::AlignVCenter | Qt::AlignRight,
                   joint.angle);
  painter.setPen(Qt::NoPen);
  painter.setBrush(theme_.colour(QStringLiteral("disabled")));
  painter.drawRoundedRect(place, kTrack_px / 2, kTrack_px / 2);
  painter.drawRoundedRect(speed, kTrack_px / 2, kTrack_px / 2);
  const double middle = speed.center().x();
  const double reach = joint.speed_share * speed.width() / 2;
  painter.setBrush(theme_.colour(QStringLiteral("accent")));
  painter.drawRect(QRectF(std::min(middle, middle + reach), speed.top(), std::abs(reach), speed.height()));
  painter.fillRect(QRectF(middle - 0.75, speed.top() - 2, 1.5, speed.height() + 4),
                   theme_.colour(QStringLiteral("border_strong")));
  painter.setPen(QPen(theme_.colour(QStringLiteral("surface")), 1.5));
  painter.setBrush(theme_.colour(QLatin1String(joint.near_limit ? "bad" : "accent")));
  const QPointF thumb(place.left() + joint.place * place.width(), place.center().y());
  if (joint.near_limit)
    painter.drawRect(QRectF(thumb - QPointF(5, 6), QSizeF(10, 12)));
  else
    painter.drawEllipse(thumb, 6, 6);
}

}  // namespace mirrorarm::ui
