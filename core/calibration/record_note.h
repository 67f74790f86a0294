#pragma once

#include <span>
#include <string>

#include "core/calibration/board.h"
#include "core/calibration/calibration_figures.h"
#include "core/camera/stereo_rig.h"

namespace mirrorarm::calibration {

/// A board as the command line writes it: what boardOf() reads.
[[nodiscard]] std::string textOf(const Board& board);

/// What every calibration of lenses records: how, by which software, of which board, from which images and
/// with what error. Date and serial numbers are the caller's.
[[nodiscard]] camera::CalibrationNote noteOf(const std::string& method, const Board& board, double rms_px,
                                             std::span<const ViewResidual> views, const HoldOut& hold_out);

}  // namespace mirrorarm::calibration
