#pragma once

#include <optional>

#include "core/calibration/camera_calibration.h"
#include "core/calibration/hold_out.h"
#include "core/camera/stereo_rig.h"

namespace mirrorarm::calibration {

struct StereoCalibration {
  camera::StereoRig rig;              ///< with its calibration note, the date left empty
  double rms_px = 0.0;                ///< distance of a corner from its projection, both cameras
  std::size_t views = 0;              ///< behind the fit
  std::vector<std::string> outliers;  ///< names of the views left out
  std::optional<HoldOut> hold_out;
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
