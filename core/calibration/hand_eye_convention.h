#pragma once

#include <optional>
#include <span>

#include "core/calibration/hand_eye.h"

namespace mirrorarm::calibration {

/// What is wrong with how the poses are given, if it shows: another reading of them (inverted, camera carried
/// by the other of flange and base, quaternions w first) under which robot and camera agree, at least three
/// times better than as given. Readings come in twos that are the same equations: robot inverted, and camera
/// inverted or carried by the other; as given, and both inverted. Those are told apart by what lies where:
/// what rides on the flange is within 0.3 m of it, or at least nearer than the other is to the base, and the
/// object lies before the camera.
[[nodiscard]] std::optional<HandEyeError> wrongConvention(std::span<const PosePair> pairs, CameraMount mount);

}  // namespace mirrorarm::calibration
