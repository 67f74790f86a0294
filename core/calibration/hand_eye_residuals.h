#pragma once

#include <span>
#include <vector>

#include "core/calibration/hand_eye.h"

namespace mirrorarm::calibration {

/// The pairs as if the camera were in the hand: X_FB in place of X_BF where it is not.
[[nodiscard]] std::vector<PosePair> asInHand(std::span<const PosePair> pairs, CameraMount mount);

/// Writes X_QM, `rms_m`, `rms_rad` and `stations` of a solution whose X_PC and outliers are known. `pairs` as
/// if the camera were in the hand.
void fillResiduals(std::span<const PosePair> pairs, HandEyeSolution& solution);

}  // namespace mirrorarm::calibration
