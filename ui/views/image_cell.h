#pragma once

#include <optional>
#include <vector>

#include <QImage>
#include <QRectF>
#include <QString>

#include "core/camera/image.h"
#include "core/vision/detected_marker.h"

class QPainter;

namespace mirrorarm::ui {

class Theme;

/// What is drawn over one camera image, in its raw pixels.
struct ImageOverlay {
  struct Mark {
    vision::Ellipse ellipse;
    QPointF centre_px;
    std::optional<int> identity;  ///< number of the taught marker
  };
  std::vector<Mark> marks;
  std::vector<QPolygonF> epipolar_lines;
};

/// A part of a camera image in a rectangle of the screen, with what was found in it.
class ImageCell {
 public:
  /// `source_px`: what of the image is shown; `area`: where, in the same proportions.
  ImageCell(const camera::GreyImage& image, const QRectF& source_px, const QRectF& area);

  void draw(QPainter& painter, const ImageOverlay& overlay, const Theme& theme, const QString& caption) const;

 private:
  [[nodiscard]] QPointF onScreen(const QPointF& pixel) const;
  void drawImage(QPainter& painter) const;
  void drawMark(QPainter& painter, const ImageOverlay::Mark& mark, const Theme& theme) const;
  void drawCaption(QPainter& painter, const QString& caption, const Theme& theme) const;

  const camera::GreyImage& image_;
  QRectF source_px_;
  QRectF area_;
  double scale_;  ///< screen pixels an image pixel
};

/// The largest rectangle of the proportions of `inner` in the middle of `outer`.
[[nodiscard]] QRectF fitted(const QSizeF& inner, const QRectF& outer);

}  // namespace mirrorarm::ui
