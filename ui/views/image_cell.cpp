#include "ui/views/image_cell.h"

#include <algorithm>
#include <numbers>

#include <QPainter>
#include <QPainterPath>

#include "ui/views/theme.h"

namespace mirrorarm::ui {
namespace {

constexpr double kSmallestMark_px = 3.5;  // on screen: smaller ones could not be seen
constexpr double kLabelGap_px = 3.0;
constexpr double kLabelScale = 0.3;  // smaller than this the numbers would cover each other

/// The image's own pixels, not copied.
QImage wrap(const camera::ImageView& view) {
  return {view.data, view.width_px, view.height_px, static_cast<int>(view.stride), QImage::Format_Grayscale8};
}

/// Text that stays legible on any ground.
void drawHaloed(QPainter& painter, const QPointF& place, const QString& text, const Theme& theme) {
  QPainterPath path;
  path.addText(place, painter.font(), text);
  painter.strokePath(path, QPen(theme.colour(QStringLiteral("image_ground")), 3.0));
  painter.fillPath(path, theme.colour(QStringLiteral("image_text")));
}

}  // namespace

QRectF fitted(const QSizeF& inner, const QRectF& outer) {
  QRectF place(QPointF(), inner.scaled(outer.size(), Qt::KeepAspectRatio));
  place.moveCenter(outer.center());
  return place;
}

ImageCell::ImageCell(const camera::GreyImage& image, const QRectF& source_px, const QRectF& area)
    : image_(image), source_px_(source_px), area_(area), scale_(area.width() / source_px.width()) {}

// Pixel centres lie at integers: pixel 0 covers -0.5 to 0.5.
QPointF ImageCell::onScreen(const QPointF& pixel) const {
  return area_.topLeft() + (pixel + QPointF(0.5, 0.5) - source_px_.topLeft()) * scale_;
}

void ImageCell::draw(QPainter& painter, const ImageOverlay& overlay, const Theme& theme,
                     const QString& caption) const {
  painter.save();
  painter.setClipRect(area_);
  painter.fillRect(area_, theme.colour(QStringLiteral("image_ground")));
  if (!image_.empty()) drawImage(painter);
  painter.setRenderHint(QPainter::Antialiasing);
  QColor line = theme.colour(QStringLiteral("image_epipolar"));
  line.setAlphaF(0.45);
  painter.setPen(QPen(line, 1.0));
  for (QPolygonF polyline : overlay.epipolar_lines) {
    for (QPointF& point : polyline) point = onScreen(point);
    painter.drawPolyline(polyline);
  }
  for (const auto& mark : overlay.marks) drawMark(painter, mark, theme);
  drawCaption(painter, caption, theme);
  painter.restore();
}

void ImageCell::drawImage(QPainter& painter) const {
  const QImage whole = wrap(image_.view());
  if (scale_ >= 1.0) {
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(area_, whole, source_px_);
    return;
  }
  // Reducing by averaging keeps small discs visible, which sampling would lose.
  const QImage part = whole.copy(source_px_.toAlignedRect());
  painter.drawImage(area_.topLeft(),
                    part.scaled(area_.size().toSize(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation));
}

void ImageCell::drawMark(QPainter& painter, const ImageOverlay::Mark& mark, const Theme& theme) const {
  const QColor colour = theme.colour(QLatin1String(mark.identity ? "image_known" : "image_unknown"));
  const double major = std::max(mark.ellipse.semi_major_px * scale_, kSmallestMark_px);
  const double minor = std::max(mark.ellipse.semi_minor_px * scale_, kSmallestMark_px);
  painter.save();
  painter.translate(onScreen({mark.ellipse.centre_px.x(), mark.ellipse.centre_px.y()}));
  painter.rotate(mark.ellipse.angle_rad * 180.0 / std::numbers::pi);
  painter.setPen(QPen(colour, 1.4, mark.identity ? Qt::SolidLine : Qt::DashLine));
  painter.drawEllipse(QPointF(), major, minor);
  painter.restore();
  const QPointF centre = onScreen(mark.centre_px);
  painter.setPen(QPen(colour, 1.0));
  painter.drawLine(centre - QPointF(2, 0), centre + QPointF(2, 0));
  painter.drawLine(centre - QPointF(0, 2), centre + QPointF(0, 2));
  if (mark.identity && scale_ >= kLabelScale)
    drawHaloed(painter, centre + QPointF(major + kLabelGap_px, -kLabelGap_px),
               QString::number(*mark.identity), theme);
}

void ImageCell::drawCaption(QPainter& painter, const QString& caption, const Theme& theme) const {
  drawHaloed(painter, area_.topLeft() + QPointF(8, 17), caption, theme);
}

}  // namespace mirrorarm::ui
