#pragma once

#include "core/calibration/board.h"
#include "core/simulation/bench.h"
#include "core/station/equipment.h"
#include "core/therapy/exercise.h"

namespace mirrorarm::station {

/// The simulated bench as a station's equipment; the bench outlives it.
[[nodiscard]] Equipment equipmentOf(simulation::Bench& bench);

/// A plate of retroreflective discs that shows `board`, at the bench's place for it. The board's discs have
/// known diameters (dot plate).
[[nodiscard]] simulation::Plate plateOf(const calibration::Board& board);

/// An exercise as the simulated patient performs it.
[[nodiscard]] std::vector<simulation::MinimumJerkLeg> legsOf(const therapy::Exercise& exercise);

}  // namespace mirrorarm::station
