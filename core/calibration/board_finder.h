#pragma once

#include <string_view>

#include "core/calibration/board.h"
#include "core/calibration/sighting.h"
#include "core/camera/image.h"
#include "core/common/expected.h"

namespace mirrorarm::calibration {

/// Why an image gave no sighting.
enum class BoardMiss {
  kNotFound,     ///< no such board, or too little of it
  kLargerBoard,  ///< the pattern goes on beyond the wished size: another board
};
/// One line for an engineer: what is wrong and the remedy.
[[nodiscard]] std::string_view reason(BoardMiss miss);

/// Finds the board, its points to sub-pixels; circles may be dark or bright. Chessboards and circle grids
/// must be seen whole; of a dot plate some dots may be hidden as long as its marks tell which are which.
///
/// The order is never mirrored. A dot plate and a chessboard of an odd and an even side have one order, by
/// their marks and the colour of the squares; other boards look alike after half a turn (squares after a
/// quarter), see `orderedLike`.
[[nodiscard]] Expected<Sighting, BoardMiss> findBoard(const camera::ImageView& image, const Board& board);

/// `sighting` renumbered by whole turns of the board under which it looks alike, so that the points lie about
/// their middle as those of `reference` do: for two cameras on one bar, which stand upright alike, and for a
/// board followed from image to image.
[[nodiscard]] Sighting orderedLike(const Sighting& reference, const Sighting& sighting, const Board& board);

}  // namespace mirrorarm::calibration
