#include "core/calibration/view_solution.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/calibration/bundle_start.h"
#include "core/calibration/lens_numbers.h"
#include "core/calibration/median.h"

namespace mirrorarm::calibration {
namespace {

constexpr std::size_t kFewestViews = 3;
constexpr std::size_t kFewestPoints = 6;
constexpr double kOutlierShare = 3.0;      ///< of the median view's misfit
constexpr double kLeastOutlier_px = 0.02;  ///< a view better than this is never one
constexpr double kLargestRms_px = 3.0;
constexpr double kLargestFocalSigma = 0.03;
constexpr double kLargestOffCentre = 0.25;  ///< of the principal point, as a share of the image

std::vector<BoardView> pick(std::span<const BoardView> views, std::span<const std::size_t> which) {
  std::vector<BoardView> picked;
  for (const auto i : which) picked.push_back(views[i]);
  return picked;
}

bool showsEnough(const BoardView& view, CameraCount cameras) {
  return view.seen[0].size() >= kFewestPoints &&
         (cameras == CameraCount::kOne || view.seen[1].size() >= kFewestPoints);
}

/// All views, or with second sightings emptied for a single camera; those that show too little are outliers.
SolvedViews sorted(std::span<const BoardView> views, CameraCount cameras) {
  SolvedViews solved;
  for (std::size_t i = 0; i < views.size(); ++i)
    (showsEnough(views[i], cameras) ? solved.used : solved.outliers).push_back(i);
  return solved;
}

/// Moves the worst view from `used` to `outliers`, and its pose out of the bundle, which is then a start for
/// the rest; one at a time, because a bad view bends the fit of good ones. False when all fit.
bool dropWorst(SolvedViews& solved) {
  const auto& misfit_px = solved.fit.misfit_px;
  const auto worst = std::max_element(misfit_px.begin(), misfit_px.end());
  if (*worst <= std::max(kOutlierShare * median(misfit_px), kLeastOutlier_px)) return false;
  const auto at = worst - misfit_px.begin();
  solved.outliers.push_back(solved.used[static_cast<std::size_t>(at)]);
  solved.used.erase(solved.used.begin() + at);
  solved.fit.bundle.X_CM.erase(solved.fit.bundle.X_CM.begin() + at);
  return true;
}

bool focalLengthsAreFixed(const RobustFit& fit) {
  if (!fit.covariance) return false;
  Eigen::Index first = 0;
  for (const auto& lens : fit.bundle.cameras) {
    const double share_x = std::sqrt((*fit.covariance)(first, first)) / lens.fx_px;
    const double share_y = std::sqrt((*fit.covariance)(first + 1, first + 1)) / lens.fy_px;
    if (!(std::max(share_x, share_y) < kLargestFocalSigma)) return false;
    first += lensTerms(lens.model);
  }
  return true;
}

bool looksAtTheImage(const camera::Intrinsics& lens) {
  return std::abs(lens.cx_px / lens.width_px - 0.5) < kLargestOffCentre &&
         std::abs(lens.cy_px / lens.height_px - 0.5) < kLargestOffCentre;
}

bool isSwapped(const Bundle& bundle) {
  if (bundle.cameras.size() < 2) return false;
  const Eigen::Vector3d p_LR = bundle.X_RC.inverse().translation();
  return p_LR.x() < 0.0 && std::abs(p_LR.x()) >= p_LR.cwiseAbs().maxCoeff();
}

/// What is wrong with a solution that no sum of squares tells.
std::optional<CalibrationError> doubtOf(const RobustFit& fit) {
  if (!(fit.total_rms_px < kLargestRms_px)) return CalibrationError::kMisfit;
  if (!focalLengthsAreFixed(fit)) return CalibrationError::kViewsTooAlike;
  if (!std::ranges::all_of(fit.bundle.cameras, looksAtTheImage)) return CalibrationError::kImageSize;
  if (isSwapped(fit.bundle)) return CalibrationError::kSidesSwapped;
  return std::nullopt;
}

/// False for sightings of another image size.
bool lieWithin(std::span<const BoardView> views, ImageSize size) {
  const auto inside = [&](const SeenPoint& seen) {
    return seen.pixel.minCoeff() >= -1.0 && seen.pixel.x() <= size.width_px &&
           seen.pixel.y() <= size.height_px;
  };
  return std::ranges::all_of(views, [&](const BoardView& view) {
    return std::ranges::all_of(view.seen, [&](const Sighting& s) { return std::ranges::all_of(s, inside); });
  });
}

std::vector<std::string> namesOf(std::span<const BoardView> views, std::span<const std::size_t> which) {
  std::vector<std::string> names;
  for (const auto i : which) names.push_back(views[i].name);
  return names;
}

auto refused(CalibrationError error, std::vector<std::string> views = {}) {
  return unexpected(CalibrationRefusal{error, std::move(views)});
}

/// Solves and leaves outlier views out until all fit.
Expected<SolvedViews, CalibrationRefusal> settled(SolvedViews solved, Bundle start, const Board& board,
                                                  std::span<const BoardView> views) {
  const auto points = boardPoints(board);
  for (solved.fit.bundle = std::move(start);;) {
    auto fit = fitRobustly(solved.fit.bundle, points, pick(views, solved.used));
    if (!fit) return refused(CalibrationError::kNotSolved);
    solved.fit = std::move(*fit);
    if (!dropWorst(solved)) return solved;
    if (solved.used.size() < std::max(kFewestViews, views.size() / 2))
      return refused(CalibrationError::kMisfit, namesOf(views, solved.outliers));
  }
}

}  // namespace

Expected<SolvedViews, CalibrationRefusal> solveViews(const Board& board, std::span<const BoardView> views,
                                                     ImageSize size, camera::LensModel model,
                                                     CameraCount cameras) {
  auto usable = sorted(views, cameras);
  if (usable.used.size() < kFewestViews) return refused(CalibrationError::kTooFewViews);
  if (!lieWithin(views, size)) return refused(CalibrationError::kImageSize);
  const auto picked = pick(views, usable.used);
  auto start = cameras == CameraCount::kTwo ? startRig(board, picked, size, model)
                                            : startCamera(board, picked, size, model);
  if (!start) return unexpected(start.error());
  auto solved = settled(std::move(usable), std::move(*start), board, views);
  if (!solved) return solved;
  if (const auto doubt = doubtOf(solved->fit)) return refused(*doubt);
  std::sort(solved->outliers.begin(), solved->outliers.end());
  return solved;
}

camera::StereoRig rigOf(const Bundle& bundle) {
  camera::StereoRig rig;
  rig.left = camera::CameraModel(bundle.cameras[0]);
  if (bundle.cameras.size() < 2) return rig;
  rig.right = camera::CameraModel(bundle.cameras[1]);
  rig.X_RC = bundle.X_RC;
  return rig;
}

}  // namespace mirrorarm::calibration
