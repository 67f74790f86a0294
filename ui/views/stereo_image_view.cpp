#include "ui/views/stereo_image_view.h"

#include <algorithm>

#include <QKeyEvent>
#include <QPainter>
#include <QPushButton>

#include "ui/views/image_cell.h"

namespace mirrorarm::ui {
namespace {

constexpr double kGap_px = 6.0;
constexpr double kWideStrip = 2.4;      // wider than this: one row of three cells
constexpr double kCloseUpMargin = 1.5;  // of the markers' extent
constexpr int kButtonMargin_px = 6;

}  // namespace

StereoImageView::StereoImageView(const camera::StereoRig& rig, QWidget* parent)
    : QWidget(parent), rig_(rig), refused_button_(new QPushButton(tr("Refused lights"), this)) {
  setObjectName(QStringLiteral("stereoImageView"));
  setAccessibleName(tr("Camera images"));
  setToolTip(
      tr("Click to enlarge (Ctrl+I)\nDashed: partly covered. Dotted with ?: several partners possible"));
  setCursor(Qt::PointingHandCursor);
  setFocusPolicy(Qt::StrongFocus);
  const QKeySequence key(QStringLiteral("Ctrl+L"));
  refused_button_->setObjectName(QStringLiteral("refusedLightsButton"));
  refused_button_->setAccessibleName(tr("Show refused lights"));
  refused_button_->setToolTip(
      tr("Say of every light why it is no marker (%1)").arg(key.toString(QKeySequence::NativeText)));
  refused_button_->setShortcut(key);
  refused_button_->setProperty("chip", true);
  refused_button_->setCheckable(true);
  refused_button_->setChecked(true);
  connect(refused_button_, &QPushButton::toggled, this, [this] { update(); });
}

void StereoImageView::setTheme(const Theme& theme) {
  theme_ = theme;
  update();
}

void StereoImageView::show(const std::shared_ptr<const station::TrackedFrame>& frame) {
  if (frame == frame_) return;
  frame_ = frame;
  overlay_ = frame_ ? overlayOf(*frame_, rig_) : StereoOverlay{};
  update();
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
  for (const auto& mark : overlay_.left.marks)
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
  const bool refused = refused_button_->isChecked();
  ImageCell(left, whole, place.left).draw(painter, overlay_.left, refused, theme_, tr("Left camera"));
  ImageCell(right, whole, place.right).draw(painter, overlay_.right, refused, theme_, tr("Right camera"));
  if (place.close_up.width() < 60 || place.close_up.height() < 60) return;
  ImageCell close_up(left, closeUpOf(place.close_up.size()), place.close_up);
  close_up.keepFree(refused_button_->geometry());
  close_up.draw(painter, overlay_.left, refused, theme_, tr("Close-up, left"));
}

// In the lower right corner, where the close-up ends.
void StereoImageView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  refused_button_->adjustSize();
  const QSize gap(kButtonMargin_px, kButtonMargin_px);
  const QSize corner = size() - refused_button_->size() - gap;
  refused_button_->move(corner.width(), corner.height());
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
