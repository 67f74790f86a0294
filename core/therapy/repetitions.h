#pragma once

#include <span>

namespace mirrorarm::therapy {

/// Out-and-back movements in a course of distances from the start: each rise above 70 % of the largest value
/// that is followed by a fall below 30 % counts once. A movement that is still out is not counted, nor is
/// anything when the largest value stays below `least_range`. Values are >= 0, in the order of time.
[[nodiscard]] int countRepetitions(std::span<const double> excursion, double least_range);

}  // namespace mirrorarm::therapy
