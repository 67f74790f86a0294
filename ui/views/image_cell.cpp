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
constexpr double kSpeck_px = 1.2;
constexpr double kCornerShare = 0.3;  // of the frame around a refused light
constexpr int kReasonFont_px = 11;
constexpr double kHalo_px = 3.0;

/// The image's own pixels, not copied.
QImage wrap(const camera::ImageView& view) {
  return {view.data, view.width_px, view.height_px, static_cast<int>(view.stride), QImage::Format_Grayscale8};
}

Qt::PenStyle outlineOf(const ImageOverlay::Mark& mark) {
  return mark.cut ? Qt::DashLine : mark.ambiguous ? Qt::DotLine : Qt::SolidLine;
}

QFont smallerThan(QFont font) {
  font.setPixelSize(kReasonFont_px);
  font.setBold(false);
  return font;
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

void ImageCell::draw(QPainter& painter, const ImageOverlay& overlay, bool with_refused, const Theme& theme,
                     const QString& caption) {
  painter.save();
  begin(painter, theme, caption);
  for (const auto& line : overlay.epipolar_lines) drawLine(painter, line, theme);
  for (const auto& mark : overlay.marks) drawMark(painter, mark, theme);
  if (with_refused) {
    painter.setFont(smallerThan(painter.font()));
    for (const auto& light : overlay.refused) drawRefused(painter, light, theme);
  }
  painter.restore();
}

void ImageCell::begin(QPainter& painter, const Theme& theme, const QString& caption) {
  painter.setClipRect(area_);
  painter.fillRect(area_, theme.colour(QStringLiteral("image_ground")));
  if (!image_.empty()) drawImage(painter);
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor text = theme.colour(QStringLiteral("image_text"));
  drawLabel(painter, area_.topLeft() + QPointF(8, 17), caption, text, theme);
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

void ImageCell::drawLine(QPainter& painter, const ImageOverlay::EpipolarLine& line,
                         const Theme& theme) const {
  QColor colour = theme.colour(QLatin1String(line.ambiguous ? "image_unknown" : "image_epipolar"));
  colour.setAlphaF(0.45);
  painter.setPen(QPen(colour, 1.0, line.ambiguous ? Qt::DotLine : Qt::SolidLine));
  QPolygonF polyline;
  for (const QPointF& point : line.points_px) polyline << onScreen(point);
  painter.drawPolyline(polyline);
}

void ImageCell::drawMark(QPainter& painter, const ImageOverlay::Mark& mark, const Theme& theme) {
  const QColor colour = theme.colour(QLatin1String(mark.identity ? "image_known" : "image_unknown"));
  const double major = std::max(mark.ellipse.semi_major_px * scale_, kSmallestMark_px);
  const double minor = std::max(mark.ellipse.semi_minor_px * scale_, kSmallestMark_px);
  painter.save();
  painter.translate(onScreen({mark.ellipse.centre_px.x(), mark.ellipse.centre_px.y()}));
  painter.rotate(mark.ellipse.angle_rad * 180.0 / std::numbers::pi);
  painter.setPen(QPen(colour, 1.4, outlineOf(mark)));
  painter.drawEllipse(QPointF(), major, minor);
  painter.restore();
  const QPointF centre = onScreen(mark.centre_px);
  painter.setPen(QPen(colour, 1.0));
  painter.drawLine(centre - QPointF(2, 0), centre + QPointF(2, 0));
  painter.drawLine(centre - QPointF(0, 2), centre + QPointF(0, 2));
  if (!mark.label.isEmpty() && scale_ >= kLabelScale && area_.contains(centre))
    drawLabel(painter, centre + QPointF(major + kLabelGap_px, -kLabelGap_px), mark.label,
              theme.colour(QStringLiteral("image_text")), theme);
}

// The corners of a frame: discreet, and not to be taken for an outline.
void ImageCell::drawRefused(QPainter& painter, const ImageOverlay::RefusedLight& light, const Theme& theme) {
  const QColor colour = theme.colour(QStringLiteral("image_refused"));
  const QPointF centre = onScreen(light.centre_px);
  if (light.reason.isEmpty()) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawEllipse(centre, kSpeck_px, kSpeck_px);
    painter.setBrush(Qt::NoBrush);
    return;
  }
  const double half = std::max(0.5 * light.extent_px * scale_, kSmallestMark_px) + 2.0;
  painter.setPen(QPen(colour, 1.0));
  for (const double x : {-half, half})
    for (const double y : {-half, half}) {
      const QPointF corner = centre + QPointF(x, y);
      painter.drawLine(corner, corner - QPointF(kCornerShare * x, 0));
      painter.drawLine(corner, corner - QPointF(0, kCornerShare * y));
    }
  if (scale_ >= kLabelScale && area_.contains(centre))
    drawLabel(painter, centre + QPointF(half + kLabelGap_px, kLabelGap_px), light.reason, colour, theme);
}

void ImageCell::drawLabel(QPainter& painter, const QPointF& place, const QString& text, const QColor& colour,
                          const Theme& theme) {
  QPainterPath path;
  path.addText(place, painter.font(), text);
  QRectF box = path.boundingRect().adjusted(-kHalo_px, -kHalo_px, kHalo_px, kHalo_px);
  const double beyond = std::max(box.right() - area_.right(), 0.0);
  path.translate(-beyond, 0.0);
  box.translate(-beyond, 0.0);
  const bool taken = std::any_of(labels_.begin(), labels_.end(),
                                 [&box](const QRectF& other) { return other.intersects(box); });
  if (taken) return;
  labels_.push_back(box);
  painter.strokePath(path, QPen(theme.colour(QStringLiteral("image_ground")), kHalo_px));
  painter.fillPath(path, colour);
}

}  // namespace mirrorarm::ui
