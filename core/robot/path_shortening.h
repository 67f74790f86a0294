#pragma once

#include <vector>

#include "core/robot/path_search.h"

namespace mirrorarm::robot {

/// A shorter path with the same ends, all of it passable. Deterministic: OMPL's own simplifier draws from
/// generators that nobody can seed.
[[nodiscard]] std::vector<Joints> shortened(std::vector<Joints> path, const Passable& passable);

/// What comes after the first point of the path, long edges split so that a spline through all stays near
/// them, as far as `most` points allow it.
[[nodiscard]] std::vector<Joints> splitEdges(const std::vector<Joints>& path, std::size_t most);

}  // namespace mirrorarm::robot
