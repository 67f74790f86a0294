#include "core/calibration/camera_calibration.h"

#include <algorithm>

namespace mirrorarm::calibration {
namespace {

constexpr std::size_t kFewestViews = 3;
constexpr int kRounds = 3;
constexpr double kOutlierShare = 3.0;     ///< of the median view's misfit
constexpr double kLeastOutlier_px = 0.1;  ///< a view better than this is never one
constexpr double kLargestRms_px = 5.0;
constexpr double kLargestFocalSigma = 0.03;

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::vector<BoardView> pick(std::span<const BoardView> views, std::span<const std::size_t> which) {
  std::vector<BoardView> picked;
  for (const auto i : which) picked.push_back(views[i]);
  return picked;
}

/// Moves the views that fit badly from `used` to `outliers` and their poses out of the bundle, which is then
/// a start for the rest. False when all fit.
bool dropOutliers(SolvedViews& solved) {
  const double limit_px = std::max(kOutlierShare * median(solved.fit.view_rms_px), kLeastOutlier_px);
  std::vector<std::size_t> kept;
  std::vector<RigidTransform> poses;
  for (std::size_t i = 0; i < solved.used.size(); ++i) {
    const bool fits = solved.fit.view_rms_px[i] <= limit_px;
    (fits ? kept : solved.outliers).push_back(solved.used[i]);
    if (fits) poses.push_back(solved.fit.bundle.X_CM[i]);
  }
  if (kept.size() == solved.used.size()) return false;
  solved.used = std::move(kept);
  solved.fit.bundle.X_CM = std::move(poses);
  return true;
}

Expected<SolvedViews, CalibrationError> checked(SolvedViews solved) {
  if (solved.fit.rms_px > kLargestRms_px) return unexpected(CalibrationError::kMisfit);
  if (!(solved.fit.focal_sigma_share < kLargestFocalSigma))
    return unexpected(CalibrationError::kViewsTooAlike);
  std::sort(solved.outliers.begin(), solved.outliers.end());
  return solved;
}

}  // namespace

std::string_view reason(CalibrationError error) {
  switch (error) {
    case CalibrationError::kTooFewViews:
      return "fewer than 3 usable views of the board: capture more, better 20";
    case CalibrationError::kNotSolved:
      return "no lens fits the views: check the board's size and the model";
    case CalibrationError::kViewsTooAlike:
      return "the views do not fix the focal length: tilt the board by 20 to 45 degrees in all directions";
    case CalibrationError::kMisfit:
      return "the best lens is more than 5 px off: check the board's size and that it is flat";
  }
  return "is refused";
}

Expected<SolvedViews, CalibrationError> solveViews(const Board& board, std::span<const BoardView> views,
                                                   ImageSize size, camera::LensModel model) {
  if (views.size() < kFewestViews) return unexpected(CalibrationError::kTooFewViews);
  const auto points = boardPoints(board);
  const bool is_rig = !views.front().pixels[1].empty();
  auto fit = is_rig ? fitRig(points, views, size, model) : fitCamera(points, views, size, model);
  if (!fit) return unexpected(CalibrationError::kNotSolved);
  SolvedViews solved{std::move(*fit), {}, {}};
  for (std::size_t i = 0; i < views.size(); ++i) solved.used.push_back(i);
  for (int round = 0; round < kRounds && dropOutliers(solved); ++round) {
    if (solved.used.size() < kFewestViews) return unexpected(CalibrationError::kTooFewViews);
    auto again = adjustBundle(solved.fit.bundle, points, pick(views, solved.used));
    if (!again) return unexpected(CalibrationError::kNotSolved);
    solved.fit = std::move(*again);
  }
  return checked(std::move(solved));
}

Expected<CameraCalibration, CalibrationError> calibrateCamera(const Board& board,
                                                              std::span<const BoardView> views,
                                                              ImageSize size, camera::LensModel model) {
  const auto solved = solveViews(board, views, size, model);
  if (!solved) return unexpected(solved.error());
  CameraCalibration result;
  result.camera = camera::CameraModel(solved->fit.bundle.cameras[0]);
  result.rms_px = solved->fit.rms_px;
  result.views = solved->used.size();
  for (const auto i : solved->outliers) result.outliers.push_back(views[i].name);
  return result;
}

}  // namespace mirrorarm::calibration
