#pragma once

#include <functional>
#include <optional>
#include <span>

#include "core/calibration/board.h"
#include "core/calibration/pose_pairs.h"
#include "core/calibration/sighting.h"
#include "core/camera/stereo_rig.h"

namespace mirrorarm::calibration {

/// Where board and camera should stand to each other next.
struct ViewWish {
  RigidTransform X_CM = RigidTransform::Identity();
  /// How much it shrinks what is uncertain: natural logarithm of the determinant of the information matrix of
  /// all numbers asked for, after against before.
  double gain = 0.0;
};

/// Whether a view can be had at all: the robot reaches it without touching anything, or true for a board in
/// the hand.
using Reachable = std::function<bool(const RigidTransform& X_CM)>;

/// The view that tells most about both lenses and the bar between them, given those so far: of tilts to 45
/// degrees, distances and places in both images where both cameras see most of the board, and which are
/// `reachable`, the one of largest gain (D-optimal design). `rig` may be rough: as it is known so far.
/// Nothing when none is reachable.
[[nodiscard]] std::optional<ViewWish> nextStereoView(const camera::StereoRig& rig, const Board& board,
                                                     std::span<const RigidTransform> X_CM_taken,
                                                     const Reachable& reachable);

/// The same for the camera on the flange: what counts is how the turns of the flange fix X_FC.
[[nodiscard]] std::optional<ViewWish> nextHandEyeView(const camera::StereoRig& rig, const Board& board,
                                                      const RigidTransform& X_FC,
                                                      std::span<const PosePair> taken,
                                                      const Reachable& reachable);

}  // namespace mirrorarm::calibration
