#pragma once

#include <optional>
#include <span>

#include "core/calibration/board.h"
#include "core/calibration/sighting.h"
#include "core/camera/stereo_rig.h"

namespace mirrorarm::benchmarks::calibration {

struct OpenCvStereo {
  camera::StereoRig rig;
  double rms_px = 0.0;
};

/// The same views by OpenCV's own bundle adjustment: each camera alone, then both and the bar together; two
/// radial terms (brown_conrady) or four (kannala_brandt); views of which both cameras show all points.
/// Nothing where OpenCV gives up.
[[nodiscard]] std::optional<OpenCvStereo> solveByOpenCv(
    const mirrorarm::calibration::Board& board, std::span<const mirrorarm::calibration::BoardView> views,
    mirrorarm::calibration::ImageSize size, camera::LensModel model);

}  // namespace mirrorarm::benchmarks::calibration
