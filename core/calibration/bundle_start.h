#pragma once

#include <optional>
#include <span>

#include "core/calibration/bundle.h"

namespace mirrorarm::calibration {

/// A single camera from its views alone (first pixels of each), from nothing: lenses of several angles of
/// view without distortion are tried, the board posed under each (solvePnP, IPPE) and all refined; the best
/// fit is taken. Nothing when no lens fits. At least one view.
[[nodiscard]] std::optional<BundleFit> fitCamera(std::span<const Eigen::Vector3d> board,
                                                 std::span<const BoardView> views, ImageSize size,
                                                 camera::LensModel model);

/// Two cameras: each alone, then everything together from the bar that most views agree on.
[[nodiscard]] std::optional<BundleFit> fitRig(std::span<const Eigen::Vector3d> board,
                                              std::span<const BoardView> views, ImageSize size,
                                              camera::LensModel model);

}  // namespace mirrorarm::calibration
