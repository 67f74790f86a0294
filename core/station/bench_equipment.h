#pragma once

#include "core/simulation/bench.h"
#include "core/station/equipment.h"
#include "core/therapy/exercise.h"

namespace mirrorarm::station {

/// The simulated bench as a station's equipment; the bench outlives it.
[[nodiscard]] Equipment equipmentOf(simulation::Bench& bench);

/// An exercise as the simulated patient performs it.
[[nodiscard]] std::vector<simulation::MinimumJerkLeg> legsOf(const therapy::Exercise& exercise);

}  // namespace mirrorarm::station
