#include "core/calibration/camera_calibration.h"

#include "core/calibration/board_shape.h"
#include "core/calibration/record_note.h"
#include "core/calibration/view_report.h"

namespace mirrorarm::calibration {
namespace {

constexpr auto kMethod = "robust bundle adjustment of the lens and the board's poses";

std::vector<BoardView> ofFirstCamera(std::span<const BoardView> views) {
  std::vector<BoardView> first;
  for (const auto& view : views) first.push_back({view.name, {view.seen[0], {}}});
  return first;
}

}  // namespace

Expected<CameraCalibration, CalibrationRefusal> calibrateCamera(const Board& board,
                                                                std::span<const BoardView> views,
                                                                ImageSize size,
                                                                std::optional<camera::LensModel> model) {
  const auto alone = ofFirstCamera(views);
  const auto choice = chooseModel(board, alone, size, model, CameraCount::kOne, Crossing::kRequired);
  if (!choice) return unexpected(choice.error());
  const auto& solved = choice->best.solved;
  CameraCalibration result;
  result.camera = camera::CameraModel(solved.fit.bundle.cameras[0]);
  result.rms_px = solved.fit.total_rms_px;
  result.views = solved.used.size();
  result.outliers = outlierNames(solved, alone);
  result.hold_out = choice->best.crossed->figures;
  result.residuals = residualsOf(choice->best, board, alone);
  result.sigma = lensSigmaOf(solved.fit, 0);
  result.board_shape = boardShape(solved.fit, boardPoints(board));
  result.trials = choice->trials;
  result.note = noteOf(kMethod, board, result.rms_px, result.residuals, result.hold_out);
  result.note.lens_sigma[0] = result.sigma;
  return result;
}

}  // namespace mirrorarm::calibration
