#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/calibration/calibration_figures.h"
#include "core/calibration/cross_validation.h"
#include "core/calibration/view_solution.h"

namespace mirrorarm::calibration {

struct ModelSolution {
  SolvedViews solved;
  std::optional<CrossValidation> crossed;
};

/// Whether views must be left for cross-validation: not where others are kept out to measure on.
enum class Crossing { kRequired, kWherePossible };

struct ModelChoice {
  ModelSolution best;
  std::vector<ModelTrial> trials;  ///< those that could be solved
};

/// Solves with `model`, or with every one and takes the one whose cross-validation shows the least
/// reprojection error. Refused when none solves, for the most telling of their reasons. Several models are
/// compared with crossing alone.
[[nodiscard]] Expected<ModelChoice, CalibrationRefusal> chooseModel(const Board& board,
                                                                    std::span<const BoardView> views,
                                                                    ImageSize size,
                                                                    std::optional<camera::LensModel> model,
                                                                    CameraCount cameras, Crossing crossing);

}  // namespace mirrorarm::calibration
