#pragma once

#include <filesystem>
#include <vector>

#include "core/calibration/pose_pairs.h"

namespace mirrorarm::calibration {

/// The pose samples of MoveIt's hand-eye tests: a JSON list of [effector in world, object in sensor], each a
/// 4x4 matrix by rows, metres. The world is the robot's base, the effector its flange; the sensor stands
/// beside the robot. Throws what the JSON library throws when the file is another.
[[nodiscard]] std::vector<PosePair> readMoveItPairs(const std::filesystem::path& file);

}  // namespace mirrorarm::calibration
