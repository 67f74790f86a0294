#pragma once

#include <optional>
#include <span>

#include "core/calibration/pose_pairs.h"

namespace mirrorarm::calibration {

/// X_FC by Park and Martin: the rotation that maps the camera's rotation vectors best onto the robot's, over
/// all pairs of stations that tell something; then the position. Nothing when the turns do not fix the
/// answer. Source: Park, Martin, IEEE Trans. Robotics and Automation 10(5), 1994.
[[nodiscard]] std::optional<RigidTransform> parkMartin(std::span<const PosePair> pairs);

}  // namespace mirrorarm::calibration
