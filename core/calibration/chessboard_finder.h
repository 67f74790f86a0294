#pragma once

#include "core/calibration/board.h"
#include "core/calibration/board_finder.h"

namespace mirrorarm::calibration {

/// findBoard() for a chessboard.
[[nodiscard]] Expected<Sighting, BoardMiss> findChessboard(const camera::ImageView& image,
                                                           const Board& board);

}  // namespace mirrorarm::calibration
