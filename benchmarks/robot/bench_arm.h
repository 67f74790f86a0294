#pragma once

#include <vector>

#include "core/robot/arm_description.h"

namespace mirrorarm::benchmarks::robot {

/// The project's LBR 4+. Throws std::runtime_error where its file cannot be read, like the next.
[[nodiscard]] mirrorarm::robot::ArmDescription lbr();

/// Camera bar and sling on the arm's flange.
[[nodiscard]] std::vector<mirrorarm::robot::Capsule> handOn(const mirrorarm::robot::ArmDescription& arm);

}  // namespace mirrorarm::benchmarks::robot
