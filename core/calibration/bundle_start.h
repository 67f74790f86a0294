#pragma once

#include <span>

#include "core/calibration/board.h"
#include "core/calibration/bundle.h"
#include "core/calibration/calibration_refusal.h"
#include "core/common/expected.h"

namespace mirrorarm::calibration {

/// A single camera from its views alone (first sightings of each), from nothing: lenses of several angles of
/// view without distortion are tried, the board posed under each (planarPoses) and all refined; the best is
/// taken and the board posed once more under it, so that no view stays with the mirrored tilt. Refused when
/// no lens fits. At least one view, each with 4 points.
[[nodiscard]] Expected<Bundle, CalibrationRefusal> startCamera(const Board& board,
                                                               std::span<const BoardView> views,
                                                               ImageSize size, camera::LensModel model);

/// Two cameras: each alone, then the bar that most views agree on. Refused, with the views' names, where left
/// and right images are paired wrongly.
[[nodiscard]] Expected<Bundle, CalibrationRefusal> startRig(const Board& board,
                                                            std::span<const BoardView> views, ImageSize size,
                                                            camera::LensModel model);

}  // namespace mirrorarm::calibration
