#include "ui/views/stereo_image_view.h"

#include <algorithm>

#include <QKeyEvent>
#include <QPainter>

namespace mirrorarm::ui {
namespace {

constexpr double kGap_px = 6.0;
constexpr double kWideStrip = 2.4;      // wider than this: one row of three cells
constexpr double kCloseUpMargin = 1.5;  // of the markers' extent
constexpr double kNearest_m = 0.15, kFarthest_m = 2.5;
constexpr int kLineSteps = 14;

}  // namespace

StereoImageView::StereoImageView(const camera::StereoRig& rig, QWidget* parent) : QWidget(parent), rig_(rig) {
  setObjectName(QStringLiteral("stereoImageView"));
  setAccessibleName(tr("Camera images"));
  setToolTip(tr("Click to enlarge (Ctrl+I)"));
  setCursor(Qt::PointingHandCursor);
  setFocusPolicy(Qt::StrongFocus);
}

void StereoImageView::setTheme(const Theme& theme) {
  theme_ = theme;
  update();
}

void StereoImageView::show(const std::shared_ptr<const station::TrackedFrame>& frame) {
  if (frame == frame_) return;
  frame_ = frame;
  readOverlays();
  update();
}

void StereoImageView::readOverlays() {
  overlays_ = {};
  if (!frame_) return;
  const auto& seen = frame_->observation;
  std::vector<int> left(seen.left.markers.size(), -1);
  std::vector<int> right(seen.right.markers.size(), -1);
  if (!frame_->targets.empty()) {
    const auto& target = frame_->targets.front();
    for (int marker = 0; marker < target.marker_count; ++marker) {
      const auto point = target.point_of_marker[static_cast<std::size_t>(marker)];
      if (point < 0 || static_cast<std::size_t>(point) >= seen.points.size()) continue;
      left[static_cast<std::size_t>(seen.points[static_cast<std::size_t>(point)].left)] = marker + 1;
      right[static_cast<std::size_t>(seen.points[static_cast<std::size_t>(point)].right)] = marker + 1;
    }
  }
  addMarks(seen.left, left, overlays_[0]);
  addMarks(seen.right, right, overlays_[1]);
  for (const auto& point : seen.points)
    overlays_[1].epipolar_lines.push_back(
        epipolarLine(seen.left.markers[static_cast<std::size_t>(point.left)].centre_px));
}

void StereoImageView::addMarks(const vision::Detection& detection, const std::vector<int>& identities,
                               ImageOverlay& overlay) const {
  for (std::size_t i = 0; i < detection.markers.size(); ++i) {
    const auto& marker = detection.markers[i];
    const auto identity = identities[i] > 0 ? std::optional(identities[i]) : std::nullopt;
    overlay.marks.push_back({marker.ellipse, {marker.centre_px.x(), marker.centre_px.y()}, identity});
  }
}

// Where the ray of a left pixel lies in the right image: a line through a pinhole, a curve through a fisheye.
QPolygonF StereoImageView::epipolarLine(const Eigen::Vector2d& left_px) const {
  QPolygonF line;
  const auto ray = rig_.left.unproject(left_px);
  for (int step = 0; ray && step <= kLineSteps; ++step) {
    const double inverse_depth =
        1.0 / kFarthest_m + (1.0 / kNearest_m - 1.0 / kFarthest_m) * step / kLineSteps;
    const Eigen::Vector3d p_C = Eigen::Vector3d(ray->x(), ray->y(), 1.0) / inverse_depth;
    const auto pixel = rig_.right.project(rig_.X_RC * p_C);
    if (pixel) line << QPointF(pixel->x(), pixel->y());
  }
  return line;
}

StereoImageView::Places StereoImageView::places() const {
  const auto& size = rig_.left.intrinsics();
  const QSizeF image(std::max(size.width_px, 1), std::max(size.height_px, 1));
  const QRectF all = rect();
  if (all.width() > kWideStrip * all.height()) {
    const QSizeF cell = image.scaled(QSizeF(all.width(), all.height()), Qt::KeepAspectRatio);
    const QRectF left(all.topLeft(), cell);
    const QRectF right = left.translated(cell.width() + kGap_px, 0);
    return {left, right, QRectF(QPointF(right.right() + kGap_px, all.top()), all.bottomRight())};
  }
  const double half = (all.width() - kGap_px) / 2;
  const QSizeF cell = image.scaled(QSizeF(half, all.height() * 0.6), Qt::KeepAspectRatio);
  const double side = (all.width() - 2 * cell.width() - kGap_px) / 2;
  const QRectF left(QPointF(side, 0), cell);
  return {left, left.translated(cell.width() + kGap_px, 0),
          QRectF(QPointF(0, cell.height() + kGap_px), all.bottomRight())};
}

/// The markers of the left image with a margin, in the proportions of the place; the whole image without
/// markers.
QRectF StereoImageView::closeUpOf(const QSizeF& place) const {
  const QRectF whole(0, 0, frame_->frame.left.width(), frame_->frame.left.height());
  QPolygonF centres;
  for (const auto& mark : overlays_[0].marks)
    if (mark.identity || frame_->targets.empty()) centres << mark.centre_px;
  if (centres.isEmpty()) return fitted(place, whole);
  const QRectF extent = centres.boundingRect();
  const double width = std::max({extent.width() * kCloseUpMargin,
                                 extent.height() * kCloseUpMargin * place.width() / place.height(), 120.0});
  QRectF source(0, 0, width, width * place.height() / place.width());
  source.moveCenter(extent.center());
  return source;
}

void StereoImageView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  QFont font = painter.font();
  font.setPixelSize(12);
  font.setBold(true);
  painter.setFont(font);
  const Places place = places();
  if (!frame_ || frame_->frame.left.empty()) {
    painter.fillRect(rect(), theme_.colour(QStringLiteral("image_ground")));
    painter.setPen(theme_.colour(QStringLiteral("image_text")));
    painter.drawText(rect(), Qt::AlignCenter, tr("No images yet"));
    return;
  }
  const auto& [left, right] = std::tie(frame_->frame.left, frame_->frame.right);
  const QRectF whole(0, 0, left.width(), left.height());
  ImageCell(left, whole, place.left).draw(painter, overlays_[0], theme_, tr("Left camera"));
  ImageCell(right, whole, place.right).draw(painter, overlays_[1], theme_, tr("Right camera"));
  if (place.close_up.width() < 60 || place.close_up.height() < 60) return;
  ImageCell(left, closeUpOf(place.close_up.size()), place.close_up)
      .draw(painter, overlays_[0], theme_, tr("Close-up, left"));
}

void StereoImageView::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) emit enlargeWanted();
}

void StereoImageView::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
    emit enlargeWanted();
  else
    QWidget::keyPressEvent(event);
}

}  // namespace mirrorarm::ui
