#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/camera/stereo_rig.h"

namespace mirrorarm::calibration {

/// Poses of a board in the left camera, spread evenly over tilts to 40 degrees in all directions, turns in
/// the board's plane to 45 degrees, distances of 0.28 to 0.6 m and places all over the images, in which both
/// cameras see at least four fifths of `board`'s points. `round` gives others each time, and the same ones
/// for the same round.
[[nodiscard]] std::vector<RigidTransform> candidateViews(const camera::StereoRig& rig,
                                                         std::span<const Eigen::Vector3d> board, int round);

}  // namespace mirrorarm::calibration
