#pragma once

#include <functional>
#include <optional>
#include <span>

#include "core/calibration/board.h"
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

/// The view that tells most about both lenses and the bar between them, given the poses of the board so far:
/// of views tilted up to 40 degrees, at 0.28 to 0.6 m and all over the images, in which both cameras see most
/// of the board and which are `reachable`, the one of largest gain (D-optimal design). `reachable` is asked
/// from the best downwards, so that it may be slow. `rig` may be rough: as it is known so far. The same
/// question gets the same answer. Nothing when none is reachable.
/// Source: Atkinson, Donev, Tobias, Optimum Experimental Designs, with SAS, 2007, chapter 10.
[[nodiscard]] std::optional<ViewWish> nextStereoView(const camera::StereoRig& rig, const Board& board,
                                                     std::span<const RigidTransform> X_CM_taken,
                                                     const Reachable& reachable);

/// The same for the camera on the flange, with a board that stands still: what counts is how the turns
/// between the stations fix X_FC.
[[nodiscard]] std::optional<ViewWish> nextHandEyeView(const camera::StereoRig& rig, const Board& board,
                                                      std::span<const RigidTransform> X_CM_taken,
                                                      const Reachable& reachable);

}  // namespace mirrorarm::calibration
