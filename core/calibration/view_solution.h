#pragma once

#include <span>
#include <vector>

#include "core/calibration/board.h"
#include "core/calibration/calibration_refusal.h"
#include "core/calibration/robust_bundle.h"
#include "core/camera/stereo_rig.h"
#include "core/common/expected.h"

namespace mirrorarm::calibration {

/// The bundle over the views that fit it.
struct SolvedViews {
  RobustFit fit;
  std::vector<std::size_t> used;      ///< views behind the fit, ascending
  std::vector<std::size_t> outliers;  ///< views left out, ascending: far worse than the others, or too empty
};

enum class CameraCount { kOne, kTwo };

/// Solves one camera or a rig from nothing; finds views more than 3 times worse than the median one, or with
/// fewer than 6 points in an image, and solves without them. At least 3 views, and half of them, must remain.
/// Refused is also what solves but cannot be true: see CalibrationError.
[[nodiscard]] Expected<SolvedViews, CalibrationRefusal> solveViews(const Board& board,
                                                                   std::span<const BoardView> views,
                                                                   ImageSize size, camera::LensModel model,
                                                                   CameraCount cameras);

/// The rig of a bundle, without a note; for a single camera only `left` counts.
[[nodiscard]] camera::StereoRig rigOf(const Bundle& bundle);

}  // namespace mirrorarm::calibration
