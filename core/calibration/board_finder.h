#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/calibration/board.h"
#include "core/camera/image.h"

namespace mirrorarm::calibration {

/// Pixels of a board's points, in the order of boardPoints().
using BoardPixels = std::vector<Eigen::Vector2d>;

/// Finds the whole board, corners to sub-pixels; dark or bright circles. Nothing when a point is missing.
///
/// The order is never mirrored. A chessboard of an odd and an even side has one order, by the colour of its
/// squares; other boards look alike after half a turn (squares after a quarter), see `orderedLike`.
[[nodiscard]] std::optional<BoardPixels> findBoard(const camera::ImageView& image, const Board& board);

/// `pixels` reordered by whole turns of the board under which it looks alike, so that the points lie about
/// their middle as those of `reference` do: for two cameras on one bar, which stand upright alike.
[[nodiscard]] BoardPixels orderedLike(const BoardPixels& reference, const BoardPixels& pixels,
                                      const Board& board);

}  // namespace mirrorarm::calibration
