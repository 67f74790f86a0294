#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "core/calibration/calibration_figures.h"
#include "core/calibration/model_choice.h"

namespace mirrorarm::calibration {

/// What a solution says of all views it was given, in their order.
[[nodiscard]] std::vector<ViewResidual> residualsOf(const ModelSolution& solution, const Board& board,
                                                    std::span<const BoardView> views);

/// The same of a view that was kept out, measured by `rig`.
[[nodiscard]] ViewResidual heldOutResidual(const camera::StereoRig& rig, const Board& board,
                                           const BoardView& view);

[[nodiscard]] std::vector<std::string> outlierNames(const SolvedViews& solved,
                                                    std::span<const BoardView> views);

/// Standard deviations of camera `k`'s numbers; all 0 where the solution has no covariance.
[[nodiscard]] LensSigma lensSigmaOf(const RobustFit& fit, std::size_t k);

/// Standard deviations of a small motion of the bar: turn [rad], shift [m].
[[nodiscard]] Eigen::Matrix<double, 6, 1> barSigmaOf(const RobustFit& fit);

}  // namespace mirrorarm::calibration
