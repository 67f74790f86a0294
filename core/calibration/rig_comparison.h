#pragma once

#include <array>
#include <span>

#include "core/calibration/board.h"
#include "core/calibration/sighting.h"
#include "core/camera/stereo_rig.h"

namespace mirrorarm::calibration {

/// A new rig beside the one in force, measured on the same views: the figures of the views behind the new one
/// favour it a little.
struct RigComparison {
  double turn_deg = 0.0;         ///< of the bar
  double shift_mm = 0.0;         ///< of the right camera in the left one
  double focal_percent = 0.0;    ///< largest change of a focal length
  double epipolar_new_px = 0.0;  ///< see HoldOut
  double epipolar_old_px = 0.0;
  /// What the old rig would say of a point on the left axis against the new one, in depth [%].
  struct Depth {
    double distance_m = 0.0;
    double error_percent = 0.0;
  };
  std::array<Depth, 3> depth{};  ///< at 0.3, 0.4 and 0.6 m
};

[[nodiscard]] RigComparison compareRigs(const camera::StereoRig& next, const camera::StereoRig& in_force,
                                        const Board& board, std::span<const BoardView> views);

}  // namespace mirrorarm::calibration
