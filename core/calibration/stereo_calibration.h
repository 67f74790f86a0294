#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/calibration/board.h"
#include "core/calibration/calibration_figures.h"
#include "core/calibration/calibration_refusal.h"
#include "core/camera/stereo_rig.h"
#include "core/common/expected.h"

namespace mirrorarm::calibration {

struct StereoCalibration {
  camera::StereoRig rig;                ///< with its calibration note; date and serial numbers left empty
  double rms_px = 0.0;                  ///< distance of a point from its projection, both cameras
  std::size_t views = 0;                ///< behind the fit
  std::vector<std::string> outliers;    ///< names of the views left out
  std::optional<HoldOut> hold_out;      ///< always there
  std::vector<ViewResidual> residuals;  ///< of all views given, in their order
  std::array<LensSigma, 2> lens_sigma{};
  Eigen::Matrix<double, 6, 1> bar_sigma = Eigen::Matrix<double, 6, 1>::Zero();  ///< turn [rad], shift [m]
  std::optional<BoardShape> board_shape;                                        ///< where the views fix it
  std::vector<ModelTrial> trials;  ///< the models compared; one where it was asked for
};

/// The rig from views that both cameras saw, all numbers refined together, single bad points and views left
/// out; without a `model` the one that does better on views kept out (always by cross-validation). Source:
/// paper section 2.1; Zhang, PAMI 22(11), 2000.
///
/// With `hold_out` n >= 2 every n-th view (the second, fourth, ... for 2) is kept out of the solution and
/// only measured: the rig given is the one that the figures were measured with, solved from the other views
/// alone. Else the rig is solved from all views, and each view is measured by a rig solved without its third
/// of them.
[[nodiscard]] Expected<StereoCalibration, CalibrationRefusal> calibrateStereo(
    const Board& board, std::span<const BoardView> views, ImageSize size,
    std::optional<camera::LensModel> model = std::nullopt, std::size_t hold_out = 0);

}  // namespace mirrorarm::calibration
