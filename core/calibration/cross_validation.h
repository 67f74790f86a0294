#pragma once

#include <span>
#include <vector>

#include "core/calibration/hold_out.h"
#include "core/calibration/view_solution.h"

namespace mirrorarm::calibration {

/// How a lens model does on views that it was not solved from.
struct CrossValidation {
  HoldOut figures;             ///< over all views behind the solution
  std::vector<HoldOut> views;  ///< each of them, in the order of SolvedViews::used
};

/// Parts the views behind `solved` into 3 (each alone where there are fewer than 6), solves anew without each
/// part and measures that part. Refused with kTooFewViews when fewer than 4 views are behind the solution,
/// with kNotSolved when a part cannot be spared.
[[nodiscard]] Expected<CrossValidation, CalibrationRefusal> crossValidate(const Board& board,
                                                                          std::span<const BoardView> views,
                                                                          const SolvedViews& solved);

}  // namespace mirrorarm::calibration
