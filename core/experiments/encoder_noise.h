#pragma once

#include <cstdint>

#include "core/robot/joints.h"
#include "core/simulation/counter_random.h"

namespace mirrorarm::experiments {

inline constexpr double kEncoderNoise_rad = 1e-5;  ///< standard deviation, as the simulated robot's

/// Angles as the bench's encoders give them at the `reading`-th time.
[[nodiscard]] inline robot::Joints asRead(robot::Joints q_rad, std::uint64_t seed, std::uint64_t reading) {
  for (Eigen::Index i = 0; i < q_rad.size(); ++i)
    q_rad[i] += kEncoderNoise_rad * simulation::counterNormal(simulation::counterRandom(seed, reading),
                                                              static_cast<std::uint64_t>(i));
  return q_rad;
}

}  // namespace mirrorarm::experiments
