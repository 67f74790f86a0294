#include "ui/views/board_cell.h"

#include <algorithm>

#include <QPainter>

#include "ui/views/image_cell.h"
#include "ui/views/theme.h"

namespace mirrorarm::ui {
namespace {

constexpr int kCells = calibration::Coverage::kCells;
constexpr double kFewPoints = 12.0;  // in a cell: full colour from there on
constexpr double kPoint_px = 2.2;
constexpr double kLabelGap_px = 5.0;

/// Cells that hold points shine through; the others show the bare image.
void drawCells(QPainter& painter, const ImageCell& cell, const QSizeF& image_px,
               const calibration::Coverage::Grid& cells, const Theme& theme) {
  QColor colour = theme.colour(QStringLiteral("image_known"));
  const QSizeF size(image_px.width() / kCells, image_px.height() / kCells);
  painter.setPen(Qt::NoPen);
  for (int row = 0; row < kCells; ++row)
    for (int column = 0; column < kCells; ++column) {
      const int points = cells[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
      if (points == 0) continue;
      colour.setAlphaF(0.10 + 0.22 * std::min(points / kFewPoints, 1.0));
      const QPointF corner(column * size.width() - 0.5, row * size.height() - 0.5);
      const QPointF opposite = corner + QPointF(size.width(), size.height());
      painter.fillRect(QRectF(cell.onScreen(corner), cell.onScreen(opposite)).adjusted(0.5, 0.5, -0.5, -0.5),
                       colour);
    }
}

void drawOutline(QPainter& painter, const ImageCell& cell, const std::vector<QPointF>& outline_px,
                 const QPen& pen) {
  if (outline_px.empty()) return;
  QPolygonF outline;
  for (const QPointF& point : outline_px) outline << cell.onScreen(point);
  painter.setPen(pen);
  painter.setBrush(Qt::NoBrush);
  painter.drawPolygon(outline);
}

void drawPoints(QPainter& painter, ImageCell& cell, const BoardOverlay& overlay, const Theme& theme) {
  const QColor colour = theme.colour(QStringLiteral("image_known"));
  for (const auto& point : overlay.points) {
    const QPointF place = cell.onScreen(point.centre_px);
    painter.setPen(QPen(colour, 1.4));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(place, kPoint_px, kPoint_px);
    if (!point.label.isEmpty())
      cell.drawLabel(painter, place + QPointF(kLabelGap_px, -kLabelGap_px), point.label,
                     theme.colour(QStringLiteral("image_text")), theme);
  }
}

}  // namespace

void drawBoard(QPainter& painter, ImageCell& cell, const QSizeF& image_px, const BoardOverlay& overlay,
               const Theme& theme, const QString& caption) {
  painter.save();
  cell.begin(painter, theme, caption);
  drawCells(painter, cell, image_px, overlay.cells, theme);
  drawOutline(painter, cell, overlay.wished_px,
              QPen(theme.colour(QStringLiteral("image_unknown")), 2.2, Qt::DashLine));
  drawOutline(painter, cell, overlay.outline_px, QPen(theme.colour(QStringLiteral("image_known")), 1.4));
  drawPoints(painter, cell, overlay, theme);
  painter.restore();
}

}  // namespace mirrorarm::ui
