#pragma once

#include <span>
#include <string>

#include "core/calibration/calibration_figures.h"
#include "core/camera/stereo_rig.h"

namespace mirrorarm::calibration {

/// What every calibration of lenses records: how, by which software, from which images and with what error.
[[nodiscard]] camera::CalibrationNote noteOf(const std::string& method, double rms_px,
                                             std::span<const ViewResidual> views, const HoldOut& hold_out);

}  // namespace mirrorarm::calibration
