#include "core/calibration/bundle_start.h"

#include <array>
#include <cmath>
#include <optional>

#include "core/calibration/board_pose.h"
#include "core/calibration/pairing.h"
#include "core/calibration/planar_pose.h"

namespace mirrorarm::calibration {
namespace {

/// Horizontal angles of view to start from [rad]: from a long lens to a fisheye.
constexpr std::array<double, 5> kAngles_rad = {0.5, 0.9, 1.3, 1.8, 2.6};
/// So many steps tell which of them leads to the best.
constexpr int kTrialSteps = 25;

camera::Intrinsics plainLens(ImageSize size, camera::LensModel model, double angle_rad) {
  camera::Intrinsics lens;
  lens.model = model;
  lens.width_px = size.width_px;
  lens.height_px = size.height_px;
  const double extent =
      model == camera::LensModel::kBrownConrady ? 2.0 * std::tan(angle_rad / 2.0) : angle_rad;
  lens.fx_px = lens.fy_px = size.width_px / extent;
  lens.cx_px = 0.5 * (size.width_px - 1);
  lens.cy_px = 0.5 * (size.height_px - 1);
  return lens;
}

std::optional<Bundle> posedUnder(const camera::Intrinsics& lens, std::span<const Eigen::Vector3d> board,
                                 std::span<const BoardView> views) {
  Bundle start;
  start.cameras = {lens};
  for (const auto& view : views) {
    const auto poses = planarPoses(camera::CameraModel(lens), board, view.seen[0]);
    if (poses.empty()) return std::nullopt;
    start.X_CM.push_back(poses.front());
  }
  return start;
}

void poseAnew(const Board& board, std::span<const BoardView> views, Bundle& bundle) {
  camera::StereoRig alone;
  alone.left = camera::CameraModel(bundle.cameras[0]);
  for (std::size_t v = 0; v < views.size(); ++v)
    if (const auto pose = poseBoard(alone, board, views[v])) bundle.X_CM[v] = pose->X_CM;
}

/// The views with the sightings of one camera alone.
std::vector<BoardView> seenBy(std::size_t k, std::span<const BoardView> views) {
  std::vector<BoardView> alone;
  for (const auto& view : views) alone.push_back({view.name, {view.seen[k], {}}});
  return alone;
}

CalibrationRefusal wrongPairs(std::span<const ImagePair> better, std::span<const BoardView> views) {
  CalibrationRefusal refusal{CalibrationError::kPairsOutOfOrder, {}};
  for (const auto& pair : better)
    refusal.views.push_back(views[pair.left].name + " fits the partner of " + views[pair.right].name);
  return refusal;
}

}  // namespace

Expected<Bundle, CalibrationRefusal> startCamera(const Board& board, std::span<const BoardView> views,
                                                 ImageSize size, camera::LensModel model) {
  const auto points = boardPoints(board);
  const auto alone = seenBy(0, views);
  std::optional<AdjustedBundle> best;
  for (const double angle_rad : kAngles_rad) {
    const auto start = posedUnder(plainLens(size, model, angle_rad), points, alone);
    if (!start) continue;
    auto adjusted = adjustBundle(*start, points, alone, {0.0, kTrialSteps});
    if (adjusted && (!best || adjusted->squares < best->squares)) best = std::move(adjusted);
  }
  if (!best) return unexpected(CalibrationRefusal{CalibrationError::kNotSolved, {}});
  poseAnew(board, alone, best->bundle);
  auto adjusted = adjustBundle(best->bundle, points, alone);
  return adjusted ? std::move(adjusted->bundle) : std::move(best->bundle);
}

Expected<Bundle, CalibrationRefusal> startRig(const Board& board, std::span<const BoardView> views,
                                              ImageSize size, camera::LensModel model) {
  const auto left = startCamera(board, views, size, model);
  if (!left) return unexpected(left.error());
  const auto right = startCamera(board, seenBy(1, views), size, model);
  if (!right) return unexpected(right.error());
  const auto vote = voteForBar(left->X_CM, right->X_CM);
  if (!vote.better.empty()) return unexpected(wrongPairs(vote.better, views));
  Bundle start = *left;
  start.cameras.push_back(right->cameras[0]);
  start.X_RC = vote.X_RC;
  return start;
}

}  // namespace mirrorarm::calibration
