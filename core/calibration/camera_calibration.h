#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/calibration/board.h"
#include "core/calibration/calibration_figures.h"
#include "core/calibration/calibration_refusal.h"
#include "core/camera/camera_model.h"
#include "core/common/expected.h"

namespace mirrorarm::calibration {

struct CameraCalibration {
  camera::CameraModel camera;
  camera::CalibrationNote note;         ///< date and serial numbers left empty
  double rms_px = 0.0;                  ///< distance of a point from its projection
  std::size_t views = 0;                ///< behind the fit
  std::vector<std::string> outliers;    ///< names of the views left out
  HoldOut hold_out;                     ///< reprojection alone, by cross-validation
  std::vector<ViewResidual> residuals;  ///< of all views given, in their order
  LensSigma sigma;
  std::optional<BoardShape> board_shape;  ///< where the views fix it
  std::vector<ModelTrial> trials;
};

/// One camera's lens from the first sightings of views of a board, by bundle adjustment; without a `model`
/// the one that does better on views kept out. Source: paper section 2.1; Zhang, PAMI 22(11), 2000.
[[nodiscard]] Expected<CameraCalibration, CalibrationRefusal> calibrateCamera(
    const Board& board, std::span<const BoardView> views, ImageSize size,
    std::optional<camera::LensModel> model = std::nullopt);

}  // namespace mirrorarm::calibration
