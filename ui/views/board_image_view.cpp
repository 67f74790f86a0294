#include "ui/views/board_image_view.h"

#include <QPainter>

#include "ui/views/board_cell.h"
#include "ui/views/image_cell.h"

namespace mirrorarm::ui {
namespace {

constexpr double kGap_px = 6.0;

}  // namespace

BoardImageView::BoardImageView(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("boardImageView"));
  setAccessibleName(tr("Camera images"));
  setToolTip(tr("Tinted: points have been there. Dashed: where the board is wanted next"));
}

void BoardImageView::setTheme(const Theme& theme) {
  theme_ = theme;
  update();
}

void BoardImageView::show(const station::CalibrationSnapshot& snapshot,
                          const std::optional<camera::StereoRig>& rig) {
  if (snapshot.frame == frame_) return;
  frame_ = snapshot.frame;
  overlays_ = boardOverlaysOf(snapshot, rig);
  setAccessibleDescription(tr("The left camera sees %1 points of the board, the right one %2")
                               .arg(overlays_[0].points.size())
                               .arg(overlays_[1].points.size()));
  update();
}

std::array<QRectF, 2> BoardImageView::places(const QSizeF& image) const {
  const QRectF all = rect();
  const QSizeF beside((all.width() - kGap_px) / 2, all.height());
  const QSizeF below(all.width(), (all.height() - kGap_px) / 2);
  const bool side_by_side =
      image.scaled(beside, Qt::KeepAspectRatio).width() >= image.scaled(below, Qt::KeepAspectRatio).width();
  if (side_by_side)
    return {fitted(image, QRectF(all.topLeft(), beside)),
            fitted(image, QRectF(QPointF(all.right() - beside.width(), all.top()), beside))};
  return {fitted(image, QRectF(all.topLeft(), below)),
          fitted(image, QRectF(QPointF(all.left(), all.bottom() - below.height()), below))};
}

void BoardImageView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  QFont font = painter.font();
  font.setPixelSize(12);
  font.setBold(true);
  painter.setFont(font);
  if (!frame_ || frame_->frame.left.empty()) {
    painter.fillRect(rect(), theme_.colour(QStringLiteral("image_ground")));
    painter.setPen(theme_.colour(QStringLiteral("image_text")));
    painter.drawText(rect(), Qt::AlignCenter, tr("No images yet"));
    return;
  }
  const std::array<QString, 2> captions{tr("Left camera"), tr("Right camera")};
  const std::array<const camera::GreyImage*, 2> images{&frame_->frame.left, &frame_->frame.right};
  const QSizeF size(frame_->frame.left.width(), frame_->frame.left.height());
  const auto areas = places(size);
  for (std::size_t i = 0; i < images.size(); ++i) {
    ImageCell cell(*images[i], QRectF(QPointF(), size), areas[i]);
    drawBoard(painter, cell, size, overlays_[i], theme_, captions[i]);
  }
}

}  // namespace mirrorarm::ui
