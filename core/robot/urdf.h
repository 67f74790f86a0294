#pragma once

#include <filesystem>

#include "core/common/file_error.h"
#include "core/robot/arm_description.h"

namespace mirrorarm::robot {

/// Reads a serial arm from a URDF: the chain from the root link to the only link without children, fixed
/// joints folded in, <collision> cylinders as capsules and spheres as balls. Refused: not XML, a branching
/// tree, sliding or floating joints, a joint without limits, more than kMaxJoints joints.
[[nodiscard]] FromFile<ArmDescription> readUrdf(const std::filesystem::path& file);

}  // namespace mirrorarm::robot
