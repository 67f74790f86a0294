#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/calibration/board.h"
#include "core/calibration/bundle_start.h"
#include "core/camera/camera_model.h"
#include "core/common/expected.h"

namespace mirrorarm::calibration {

/// What the operator can mend.
enum class CalibrationError {
  kTooFewViews,
  kNotSolved,
  kViewsTooAlike,
  kMisfit,
};
/// One line for an engineer: what is wrong and the remedy.
[[nodiscard]] std::string_view reason(CalibrationError error);

/// The bundle over the views that fit it.
struct SolvedViews {
  BundleFit fit;
  std::vector<std::size_t> used;      ///< views behind the fit, ascending
  std::vector<std::size_t> outliers;  ///< views left out: more than 3 times the median misfit
};

/// Solves one camera or, where the views hold second pixels, a rig; finds outlier views and solves again
/// without them. At least 3 views, and half of them, must remain.
[[nodiscard]] Expected<SolvedViews, CalibrationError> solveViews(const Board& board,
                                                                 std::span<const BoardView> views,
                                                                 ImageSize size, camera::LensModel model);

struct CameraCalibration {
  camera::CameraModel camera;
  double rms_px = 0.0;                ///< distance of a corner from its projection
  std::size_t views = 0;              ///< behind the fit
  std::vector<std::string> outliers;  ///< names of the views left out
};

/// One camera's lens from views of a board, by bundle adjustment.
/// Source: paper section 2.1; Zhang, PAMI 22(11), 2000.
[[nodiscard]] Expected<CameraCalibration, CalibrationError> calibrateCamera(const Board& board,
                                                                            std::span<const BoardView> views,
                                                                            ImageSize size,
                                                                            camera::LensModel model);

}  // namespace mirrorarm::calibration
