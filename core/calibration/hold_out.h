#pragma once

#include <span>

#include "core/calibration/board.h"
#include "core/calibration/bundle.h"
#include "core/camera/stereo_rig.h"

namespace mirrorarm::calibration {

/// What a rig is worth on views that it was not solved from.
struct HoldOut {
  /// Root mean square distance of a raw pixel from the (curved) epipolar line of its partner, both ways.
  double epipolar_px = 0.0;
  /// Triangulated length between neighbouring board points against the true one, over all of them [%].
  double square_mean_percent = 0.0;
  double square_std_percent = 0.0;
  /// Root mean square distance, along the line of sight, of a triangulated point from the board that fits all
  /// points of its view best [m].
  double depth_rms_m = 0.0;
  std::size_t views = 0;
};

/// Measures `rig` on `views`, which hold both cameras' pixels. Points outside a lens model's range are passed
/// over; without any point all is 0.
[[nodiscard]] HoldOut measureHoldOut(const camera::StereoRig& rig, const Board& board,
                                     std::span<const BoardView> views);

}  // namespace mirrorarm::calibration
