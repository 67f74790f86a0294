#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/calibration/camera_calibration.h"
#include "core/calibration/hold_out.h"
#include "core/camera/stereo_rig.h"

namespace mirrorarm::calibration {

/// How one view agrees with the rig.
struct ViewResidual {
  std::string name;
  double rms_px = 0.0;      ///< over both images, the board posed from this view alone
  bool is_outlier = false;  ///< left out of the solution
  bool is_held_out = false;
  int outlier_points = 0;  ///< of its points, farther off than the noise explains
};

/// Standard deviations of one camera's numbers.
struct LensSigma {
  double fx_px = 0.0, fy_px = 0.0, cx_px = 0.0, cy_px = 0.0;
  std::array<double, 5> distortion{};
};

/// What the views say about the board itself.
struct BoardShape {
  double flatness_rms_m = 0.0;    ///< of the points from their common plane
  double flatness_sigma_m = 0.0;  ///< what noise alone would give
  /// Step along the rows against step from row to row, minus 1 [%]: a print stretched one way.
  double stretch_percent = 0.0;
  double stretch_sigma_percent = 0.0;
  bool is_bent = false;  ///< both by more than noise and more than matters
  bool is_stretched = false;
};

/// One lens model as it was tried.
struct ModelTrial {
  camera::LensModel model = camera::LensModel::kBrownConrady;
  double rms_px = 0.0;
  double hold_out_epipolar_px = 0.0;
};

struct StereoCalibration {
  camera::StereoRig rig;              ///< with its calibration note, the date left empty
  double rms_px = 0.0;                ///< distance of a corner from its projection, both cameras
  std::size_t views = 0;              ///< behind the fit
  std::vector<std::string> outliers;  ///< names of the views left out
  std::optional<HoldOut> hold_out;
  std::vector<ViewResidual> residuals;  ///< of all views given, in their order
  std::array<LensSigma, 2> lens_sigma{};
  Eigen::Matrix<double, 6, 1> bar_sigma = Eigen::Matrix<double, 6, 1>::Zero();  ///< turn [rad], shift [m]
  std::optional<BoardShape> board_shape;                                        ///< where the views fix it
  std::vector<ModelTrial> trials;  ///< the models compared; one where it was asked for
};

/// The rig from views that both cameras saw, all numbers refined together. With `hold_out` n >= 2 every n-th
/// view (the second, fourth, ... for 2) is kept out of the solution and only measured: the rig given is the
/// one that the figures were measured with, solved from the other views alone. 0 keeps none. Source: paper
/// section 2.1; Zhang, PAMI 22(11), 2000.
[[nodiscard]] Expected<StereoCalibration, CalibrationError> calibrateStereo(const Board& board,
                                                                            std::span<const BoardView> views,
                                                                            ImageSize size,
                                                                            camera::LensModel model,
                                                                            std::size_t hold_out = 0);

}  // namespace mirrorarm::calibration
