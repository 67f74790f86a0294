#include "core/calibration/stereo_calibration.h"

#include "core/calibration/board_shape.h"
#include "core/calibration/record_note.h"
#include "core/calibration/view_report.h"

namespace mirrorarm::calibration {
namespace {

constexpr auto kMethod = "robust bundle adjustment of both cameras, their bar and the board's poses";

bool isKept(std::size_t view, std::size_t hold_out) {
  return hold_out > 0 && view % hold_out == hold_out - 1;
}

struct Parts {
  std::vector<BoardView> solved;
  std::vector<BoardView> kept;
};

Parts split(std::span<const BoardView> views, std::size_t hold_out) {
  Parts parts;
  for (std::size_t i = 0; i < views.size(); ++i)
    (isKept(i, hold_out) ? parts.kept : parts.solved).push_back(views[i]);
  return parts;
}

/// Figures of the views that the solution had, and of those kept out, in the order they were given.
std::vector<ViewResidual> allResiduals(const ModelSolution& solution, const Board& board,
                                       std::span<const BoardView> views, const Parts& parts,
                                       std::size_t hold_out) {
  const auto rig = rigOf(solution.solved.fit.bundle);
  auto solved = residualsOf(solution, board, parts.solved);
  std::vector<ViewResidual> all;
  auto next = solved.begin();
  for (std::size_t i = 0; i < views.size(); ++i)
    all.push_back(isKept(i, hold_out) ? heldOutResidual(rig, board, views[i]) : std::move(*next++));
  return all;
}

StereoCalibration resultOf(const ModelChoice& choice, const Board& board) {
  const auto& fit = choice.best.solved.fit;
  StereoCalibration result;
  result.rig = rigOf(fit.bundle);
  result.rms_px = fit.total_rms_px;
  result.views = choice.best.solved.used.size();
  result.lens_sigma = {lensSigmaOf(fit, 0), lensSigmaOf(fit, 1)};
  result.bar_sigma = barSigmaOf(fit);
  result.board_shape = boardShape(fit, boardPoints(board));
  result.trials = choice.trials;
  return result;
}

}  // namespace

Expected<StereoCalibration, CalibrationRefusal> calibrateStereo(const Board& board,
                                                                std::span<const BoardView> views,
                                                                ImageSize size,
                                                                std::optional<camera::LensModel> model,
                                                                std::size_t hold_out) {
  const auto parts = split(views, hold_out);
  if (hold_out > 0 && parts.kept.empty())
    return unexpected(CalibrationRefusal{CalibrationError::kTooFewViews, {}});
  const auto crossing = parts.kept.empty() ? Crossing::kRequired : Crossing::kWherePossible;
  const auto choice = chooseModel(board, parts.solved, size, model, CameraCount::kTwo, crossing);
  if (!choice) return unexpected(choice.error());
  auto result = resultOf(*choice, board);
  result.outliers = outlierNames(choice->best.solved, parts.solved);
  result.hold_out =
      parts.kept.empty() ? choice->best.crossed->figures : measureHoldOut(result.rig, board, parts.kept);
  result.residuals = allResiduals(choice->best, board, views, parts, hold_out);
  result.rig.calibration = noteOf(kMethod, board, result.rms_px, result.residuals, *result.hold_out);
  result.rig.calibration.lens_sigma = result.lens_sigma;
  result.rig.calibration.bar_sigma = result.bar_sigma;
  return result;
}

}  // namespace mirrorarm::calibration
