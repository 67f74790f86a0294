#pragma once

#include <filesystem>
#include <vector>

#include "core/common/file_error.h"
#include "core/robot/obstacle.h"

namespace mirrorarm::robot {

/// What stands around an arm: table, boxes to keep out of, the patient's head. Reads a file of the format
/// mirrorarm/surroundings/1 (docs/formats-own.md).
[[nodiscard]] FromFile<std::vector<Obstacle>> readSurroundings(const std::filesystem::path& file);

}  // namespace mirrorarm::robot
