#pragma once

#include "core/calibration/board.h"
#include "core/calibration/board_finder.h"

namespace mirrorarm::calibration {

/// findBoard() for the two kinds of circle grids, dark or bright ones.
[[nodiscard]] Expected<Sighting, BoardMiss> findCircleGrid(const camera::ImageView& image,
                                                           const Board& board);

}  // namespace mirrorarm::calibration
