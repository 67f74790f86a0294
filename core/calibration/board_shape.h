#pragma once

#include <optional>
#include <span>

#include "core/calibration/calibration_figures.h"
#include "core/calibration/robust_bundle.h"

namespace mirrorarm::calibration {

/// How far the board is from flat and evenly spaced: the heights of its points and the ratio of its steps
/// freed with everything else, one step of Gauss and Newton from the solution, the plane of the heights held.
/// Nothing where the views do not fix that, as with fewer than 5. The points' z is 0.
[[nodiscard]] std::optional<BoardShape> boardShape(const RobustFit& fit,
                                                   std::span<const Eigen::Vector3d> board);

}  // namespace mirrorarm::calibration
