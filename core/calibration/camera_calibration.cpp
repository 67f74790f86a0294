#include "core/calibration/camera_calibration.h"

#include <algorithm>

#include "core/calibration/median.h"

namespace mirrorarm::calibration {
namespace {

constexpr std::size_t kFewestViews = 3;
constexpr double kOutlierShare = 3.0;     ///< of the median view's misfit
constexpr double kLeastOutlier_px = 0.1;  ///< a view better than this is never one
constexpr double kLargestRms_px = 5.0;
constexpr double kLargestFocalSigma = 0.03;

std::vector<BoardView> pick(std::span<const BoardView> views, std::span<const std::size_t> which) {
  std::vector<BoardView> picked;
  for (const auto i : which) picked.push_back(views[i]);
  return picked;
}

/// Moves the worst view from `used` to `outliers`, and its pose out of the bundle, which is then a start for
/// the rest; one at a time, because a bad view bends the fit of good ones. False when all fit.
bool dropWorst(SolvedViews& solved) {
  const auto& rms_px = solved.fit.view_rms_px;
  const auto worst = std::max_element(rms_px.begin(), rms_px.end());
  if (*worst <= std::max(kOutlierShare * median(rms_px), kLeastOutlier_px)) return false;
  const auto at = worst - rms_px.begin();
  solved.outliers.push_back(solved.used[static_cast<std::size_t>(at)]);
  solved.used.erase(solved.used.begin() + at);
  solved.fit.bundle.X_CM.erase(solved.fit.bundle.X_CM.begin() + at);
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
      return "too few usable views of the board: 3 to solve from and 1 to keep out are the least, 20 are "
             "better";
    case CalibrationError::kNotSolved:
      return "no lens fits the views: check the board's size and the model";
    case CalibrationError::kViewsTooAlike:
      return "the views do not fix the focal length: tilt the board by 20 to 45 degrees in all directions";
    case CalibrationError::kMisfit:
      return "the views contradict each other: check the board's size, that it is flat and stood still";
  }
  return "is refused";
}

Expected<SolvedViews, CalibrationError> solveViews(const Board& board, std::span<const BoardView> views,
                                                   ImageSize size, camera::LensModel model) {
  if (views.size() < kFewestViews) return unexpected(CalibrationError::kTooFewViews);
  const auto points = boardPoints(board);
  const bool is_rig = !views.front().seen[1].empty();
  auto fit = is_rig ? fitRig(points, views, size, model) : fitCamera(points, views, size, model);
  if (!fit) return unexpected(CalibrationError::kNotSolved);
  SolvedViews solved{std::move(*fit), {}, {}};
  for (std::size_t i = 0; i < views.size(); ++i) solved.used.push_back(i);
  while (dropWorst(solved)) {
    if (solved.used.size() < std::max(kFewestViews, views.size() / 2))
      return unexpected(CalibrationError::kMisfit);
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
