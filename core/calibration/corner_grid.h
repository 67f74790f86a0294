#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/calibration/grid_pixels.h"
#include "core/camera/image.h"

namespace mirrorarm::calibration {

/// Inner corners of a chessboard in one image, held against the colours of the squares around them: what the
/// detector says is checked, and it is told whether the board goes on beyond it.
class CornerGrid {
 public:
  /// `pixels` row by row, `columns` in a row.
  CornerGrid(const camera::ImageView& image, std::span<const Eigen::Vector2d> pixels, int columns);

  /// True when nearly every corner has two dark and two bright squares about it, turn by turn.
  [[nodiscard]] bool isChessboard() const;

  /// True when the next column or row to any side has corners too.
  [[nodiscard]] bool goesOn() const;

 private:
  /// Grey of the squares about a corner: from upper left to lower right against the other two. Nothing
  /// outside the image.
  [[nodiscard]] std::optional<double> contrastAt(const Place& place) const;
  [[nodiscard]] bool isCorner(const Place& place) const;
  [[nodiscard]] bool hasCorners(const Place& first, const Place& step, int count) const;
  [[nodiscard]] std::optional<double> greyAt(const Eigen::Vector2d& pixel) const;

  camera::ImageView image_;
  int columns_ = 0, rows_ = 0;
  GridPixels pixels_;
  double contrast_ = 0.0;  ///< usual one, with the sign of the corner at {0, 0}
};

}  // namespace mirrorarm::calibration
