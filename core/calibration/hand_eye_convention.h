#pragma once

#include <optional>
#include <span>

#include "core/calibration/hand_eye.h"

namespace mirrorarm::calibration {

/// Why stations that robot and camera tell differently contradict each other: the one other way of reading
/// them under which they agree, at least three times better than as they were given. Nothing where no way
/// does. The robot's poses inverted are the same equations as a camera carried by the other of base and
/// flange: which is meant is told by what lies nearer to where it is fixed, the camera or the object.
[[nodiscard]] std::optional<HandEyeError> wrongConvention(std::span<const PosePair> pairs, CameraMount mount);

}  // namespace mirrorarm::calibration
