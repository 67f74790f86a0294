#pragma once

#include <span>
#include <vector>

#include "core/calibration/pose_pairs.h"

namespace mirrorarm::calibration {

/// Stations that contradict the others. A robust fit of X_FC (Tsai-Lenz over all pairs with Geman-McClure
/// weights, started from how well the screws of robot and camera agree) suspects those whose misfit is above
/// 4 times the median one; named is who also lies farther from where the others put it than their own
/// straying explains, with a limit that grows where the others are few. Of 1000 clean sets with normal noise
/// about 2 have a station named, for any number of stations. Indices ascend. Below 5 stations, or where the
/// fit fails, nothing is named.
[[nodiscard]] std::vector<std::size_t> contradictingStations(std::span<const PosePair> pairs);

}  // namespace mirrorarm::calibration
