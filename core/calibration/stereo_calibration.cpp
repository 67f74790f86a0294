#include "core/calibration/stereo_calibration.h"

namespace mirrorarm::calibration {
namespace {

constexpr auto kMethod = "bundle adjustment of both cameras, their bar and the board's poses";

struct Parts {
  std::vector<BoardView> solved;
  std::vector<BoardView> kept;
};

Parts split(std::span<const BoardView> views, std::size_t hold_out) {
  Parts parts;
  for (std::size_t i = 0; i < views.size(); ++i)
    (hold_out > 0 && i % hold_out == hold_out - 1 ? parts.kept : parts.solved).push_back(views[i]);
  return parts;
}

camera::StereoRig rigOf(const BundleFit& fit) {
  camera::StereoRig rig;
  rig.left = camera::CameraModel(fit.bundle.cameras[0]);
  rig.right = camera::CameraModel(fit.bundle.cameras[1]);
  rig.X_RC = fit.bundle.X_RC;
  rig.calibration.method = kMethod;
  rig.calibration.rms_px = fit.rms_px;
  return rig;
}

}  // namespace

Expected<StereoCalibration, CalibrationError> calibrateStereo(const Board& board,
                                                              std::span<const BoardView> views,
                                                              ImageSize size, camera::LensModel model,
                                                              std::size_t hold_out) {
  const auto parts = split(views, hold_out);
  if (hold_out > 0 && parts.kept.empty()) return unexpected(CalibrationError::kTooFewViews);
  const auto solved = solveViews(board, parts.solved, size, model);
  if (!solved) return unexpected(solved.error());
  StereoCalibration result;
  result.rig = rigOf(solved->fit);
  result.rms_px = solved->fit.rms_px;
  result.views = solved->used.size();
  for (const auto i : solved->outliers) result.outliers.push_back(parts.solved[i].name);
  if (parts.kept.empty()) return result;
  result.hold_out = measureHoldOut(result.rig, board, parts.kept);
  result.rig.calibration.hold_out_epipolar_px = result.hold_out->epipolar_px;
  return result;
}

}  // namespace mirrorarm::calibration
