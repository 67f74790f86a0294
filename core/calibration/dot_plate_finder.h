#pragma once

#include "core/calibration/board.h"
#include "core/calibration/board_finder.h"

namespace mirrorarm::calibration {

/// findBoard() for a dot plate.
[[nodiscard]] Expected<Sighting, BoardMiss> findDotPlate(const camera::ImageView& image, const Board& plate);

}  // namespace mirrorarm::calibration
