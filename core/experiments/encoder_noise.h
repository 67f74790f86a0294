#pragma once

#include <cstdint>

#include "core/robot/joints.h"
#include "core/simulation/counter_random.h"
#include "core/simulation/simulated_robot.h"

namespace mirrorarm::experiments {

/// Angles as the bench's encoders give them at the `reading`-th time.
[[nodiscard]] inline robot::Joints asRead(robot::Joints q_rad, std::uint64_t seed, std::uint64_t reading) {
  for (Eigen::Index i = 0; i < q_rad.size(); ++i)
    q_rad[i] +=
        simulation::kAngleNoise_rad *
        simulation::counterNormal(simulation::counterRandom(seed, reading), static_cast<std::uint64_t>(i));
  return q_rad;
}

}  // namespace mirrorarm::experiments
