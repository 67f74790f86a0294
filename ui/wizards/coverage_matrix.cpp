#include "ui/wizards/coverage_matrix.h"

#include <algorithm>

#include <QPainter>

namespace mirrorarm::ui {
namespace {

using calibration::Coverage;

constexpr int kTitles_px = 58;    // of the tilts, on the left
constexpr int kHeader_px = 18;    // of the distances, above
constexpr int kCell_px = 26;      // smallest height of one
constexpr double kManyViews = 4;  // full colour from there on

constexpr std::array<const char*, Coverage::kTilts> kTiltTitles{"0–15°", "15–30°", "30–45°", "> 45°"};

QString distanceTitle(int column) {
  const calibration::DistanceRange range;
  const double step_m = (range.farthest_m - range.nearest_m) / Coverage::kDistances;
  const auto centimetres = [&](int edge) { return qRound(100.0 * (range.nearest_m + edge * step_m)); };
  return QStringLiteral("%1–%2").arg(centimetres(column)).arg(centimetres(column + 1));
}

QFont small(QFont font) {
  font.setPixelSize(11);
  return font;
}

}  // namespace

CoverageMatrix::CoverageMatrix(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("coverageMatrix"));
  setMinimumHeight(kHeader_px + Coverage::kTilts * kCell_px);
  show(Coverage{});
}

void CoverageMatrix::setTheme(const Theme& theme) {
  theme_ = theme;
  update();
}

void CoverageMatrix::show(const Coverage& coverage) {
  views_ = coverage.pose;
  int held = 0;
  for (const auto& row : views_)
    held += static_cast<int>(std::ranges::count_if(row, [](int n) { return n > 0; }));
  setAccessibleName(
      tr("Tilts and distances with a view: %1 of %2").arg(held).arg(Coverage::kTilts * Coverage::kDistances));
  update();
}

void CoverageMatrix::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setFont(small(painter.font()));
  const double cell_width = static_cast<double>(width() - kTitles_px) / Coverage::kDistances;
  const double cell_height = static_cast<double>(height() - kHeader_px) / Coverage::kTilts;
  const QColor muted = theme_.colour(QStringLiteral("text_muted"));
  for (int row = 0; row < Coverage::kTilts; ++row) {
    const double top = kHeader_px + row * cell_height;
    painter.setPen(muted);
    painter.drawText(QRectF(0, top, kTitles_px - 8, cell_height), Qt::AlignVCenter | Qt::AlignRight,
                     QString::fromUtf8(kTiltTitles[static_cast<std::size_t>(row)]));
    for (int column = 0; column < Coverage::kDistances; ++column)
      drawCell(painter, QRectF(kTitles_px + column * cell_width, top, cell_width, cell_height),
               views_[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)]);
  }
  painter.setPen(muted);
  for (int column = 0; column < Coverage::kDistances; ++column)
    painter.drawText(QRectF(kTitles_px + column * cell_width, 0, cell_width, kHeader_px), Qt::AlignCenter,
                     distanceTitle(column));
}

void CoverageMatrix::drawCell(QPainter& painter, const QRectF& cell, int views) const {
  const QRectF body = cell.adjusted(1, 1, -1, -1);
  painter.fillRect(body, theme_.colour(QStringLiteral("surface_sunken")));
  if (views == 0) return;
  QColor colour = theme_.colour(QStringLiteral("good"));
  colour.setAlphaF(0.25 + 0.35 * std::min(views / kManyViews, 1.0));
  painter.fillRect(body, colour);
  painter.setPen(theme_.colour(QStringLiteral("text")));
  painter.drawText(body, Qt::AlignCenter, QString::number(views));
}

}  // namespace mirrorarm::ui
