#include "core/calibration/record_note.h"

namespace mirrorarm::calibration {

camera::CalibrationNote noteOf(const std::string& method, double rms_px, std::span<const ViewResidual> views,
                               const HoldOut& hold_out) {
  camera::CalibrationNote note;
  note.method = method;
  note.software = "mirrorarm " MIRRORARM_VERSION;
  note.rms_px = rms_px;
  for (const auto& view : views)
    (view.is_outlier ? note.outliers : view.is_held_out ? note.held_out : note.images).push_back(view.name);
  note.hold_out_method = hold_out.parts == 0
                             ? "views kept out of the solution"
                             : "cross-validation in " + std::to_string(hold_out.parts) + " parts";
  note.hold_out_epipolar_px = hold_out.epipolar_px;
  note.hold_out_px = hold_out.reprojection_px;
  note.square_mean_percent = hold_out.square_mean_percent;
  note.square_std_percent = hold_out.square_std_percent;
  note.depth_rms_m = hold_out.depth_rms_m;
  return note;
}

}  // namespace mirrorarm::calibration
