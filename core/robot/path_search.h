#pragma once

#include <cstdint>
#include <vector>

#include "core/common/time.h"
#include "core/robot/collision.h"
#include "core/robot/joint_ranges.h"

namespace mirrorarm::robot {

struct PathSearchSettings {
  double finest_rad = 0.01;  ///< see CollisionWorld::firstContact
  Seconds max_time{0.25};
  std::uint64_t seed = 1;
};

/// A path of straight clear edges within `bounds`, start and goal included, by RRT-Connect (OMPL); empty when
/// none was found. The same question finds the same path, unless time runs out first. Source: Kuffner,
/// LaValle, ICRA 2000.
[[nodiscard]] std::vector<Joints> searchPath(const CollisionWorld& world, const Joints& from,
                                             const Joints& to, const JointRanges& bounds,
                                             const PathSearchSettings& settings);

}  // namespace mirrorarm::robot
