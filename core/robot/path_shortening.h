#pragma once

#include <functional>
#include <vector>

#include "core/robot/joints.h"

namespace mirrorarm::robot {

using EdgeIsClear = std::function<bool(const Joints& from, const Joints& to)>;

/// A shorter path with the same ends, all its edges clear. Deterministic: OMPL's own simplifier draws from
/// generators that nobody can seed.
[[nodiscard]] std::vector<Joints> shortened(std::vector<Joints> path, const EdgeIsClear& is_clear);

/// What comes after the first point of the path, long edges split so that a spline through all stays near
/// them, as far as `most` points allow it.
[[nodiscard]] std::vector<Joints> splitEdges(const std::vector<Joints>& path, std::size_t most);

}  // namespace mirrorarm::robot
