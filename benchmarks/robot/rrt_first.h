#pragma once

#include <functional>
#include <optional>

#include "core/robot/joint_ranges.h"

namespace mirrorarm::benchmarks::robot {

/// Length [rad] of the path that RRT-Connect of OMPL finds when it is asked at once, without trying the
/// straight way first and without shortening. Edges are sampled every 0.01 rad.
[[nodiscard]] std::optional<double> rrtFirstLength(
    const mirrorarm::robot::JointRanges& ranges, const mirrorarm::robot::Joints& from,
    const mirrorarm::robot::Joints& to, const std::function<bool(const mirrorarm::robot::Joints&)>& is_clear);

}  // namespace mirrorarm::benchmarks::robot
