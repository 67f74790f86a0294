#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "core/common/file_error.h"
#include "core/geometry/rigid_transform.h"

namespace mirrorarm::calibration {

/// One standstill of the robot (a station): where its flange F was in its base B, and where the calibration
/// object M was seen in camera C. M and C are fixed to the flange and to the ground, or the other way round.
struct PosePair {
  RigidTransform X_BF = RigidTransform::Identity();
  RigidTransform X_CM = RigidTransform::Identity();
};

/// Reads a CSV with the columns bx_m,by_m,bz_m,bqx,bqy,bqz,bqw,cx_m,cy_m,cz_m,cqx,cqy,cqz,cqw in any order.
/// Refused with the line: an unknown or missing column, a number that is not finite, a quaternion whose norm
/// is not 1 to 1 %. A table without rows gives an empty list.
[[nodiscard]] FromFile<std::vector<PosePair>> readPosePairs(const std::filesystem::path& file);

/// Writes them, whole or not at all.
[[nodiscard]] Expected<void, std::string> writePosePairs(const std::filesystem::path& file,
                                                         std::span<const PosePair> pairs);

}  // namespace mirrorarm::calibration
