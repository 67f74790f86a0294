#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/common/time.h"
#include "core/robot/joint_ranges.h"

namespace mirrorarm::robot {

/// Where an arm may go.
struct Passable {
  std::function<bool(const Joints& q)> at;
  std::function<bool(const Joints& from, const Joints& to)> along;  ///< all of the straight joint motion
};

struct PathSearchSettings {
  Seconds max_time{0.25};
  std::uint64_t seed = 1;
};

/// A path of straight passable edges within `bounds`, start and goal included, by RRT-Connect (OMPL); empty
/// when none was found. The same question finds the same path, unless time runs out first. Source: Kuffner,
/// LaValle, ICRA 2000.
[[nodiscard]] std::vector<Joints> searchPath(const Passable& passable, const Joints& from, const Joints& to,
                                             const JointRanges& bounds, const PathSearchSettings& settings);

}  // namespace mirrorarm::robot
