#pragma once

#include <vector>

#include <QImage>
#include <QRectF>
#include <QString>

#include "core/camera/image.h"
#include "ui/model/image_overlay.h"

class QPainter;

namespace mirrorarm::ui {

class Theme;

/// A part of a camera image in a rectangle of the screen, with what was found in it.
class ImageCell {
 public:
  /// `source_px`: what of the image is shown; `area`: where, in the same proportions.
  ImageCell(const camera::GreyImage& image, const QRectF& source_px, const QRectF& area);

  /// No text will stand there.
  void keepFree(const QRectF& box) { labels_.push_back(box); }
  /// The image with its markers.
  void draw(QPainter& painter, const ImageOverlay& overlay, bool with_refused, const Theme& theme,
            const QString& caption);

  // For whoever draws something else over the image.
  /// The image and its caption; drawing is clipped to the cell from then on.
  void begin(QPainter& painter, const Theme& theme, const QString& caption);
  [[nodiscard]] QPointF onScreen(const QPointF& pixel) const;
  [[nodiscard]] double scale() const { return scale_; }
  /// Text that stays legible on any ground, inside the cell; left out where other text stands already.
  void drawLabel(QPainter& painter, const QPointF& place, const QString& text, const QColor& colour,
                 const Theme& theme);

 private:
  void drawImage(QPainter& painter) const;
  void drawLine(QPainter& painter, const ImageOverlay::EpipolarLine& line, const Theme& theme) const;
  void drawMark(QPainter& painter, const ImageOverlay::Mark& mark, const Theme& theme);
  void drawRefused(QPainter& painter, const ImageOverlay::RefusedLight& light, const Theme& theme);

  const camera::GreyImage& image_;
  QRectF source_px_;
  QRectF area_;
  double scale_;                ///< screen pixels an image pixel
  std::vector<QRectF> labels_;  ///< where text stands already: words would cover each other
};

/// The largest rectangle of the proportions of `inner` in the middle of `outer`.
[[nodiscard]] QRectF fitted(const QSizeF& inner, const QRectF& outer);

}  // namespace mirrorarm::ui
