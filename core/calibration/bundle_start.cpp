#include "core/calibration/bundle_start.h"

#include <array>
#include <cmath>
#include <limits>

#include <opencv2/calib3d.hpp>

namespace mirrorarm::calibration {
namespace {

/// Horizontal angles of view to start from [rad]: from a long lens to a fisheye.
constexpr std::array<double, 5> kAngles_rad = {0.5, 0.9, 1.3, 1.8, 2.6};
/// Length that weighs the turn of a bar against its shift [m].
constexpr double kTurnLength_m = 0.5;

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

RigidTransform fromRodrigues(const cv::Vec3d& turn, const cv::Vec3d& shift) {
  const Eigen::Vector3d r(turn[0], turn[1], turn[2]);
  const Eigen::AngleAxisd rotation(r.norm(), r.stableNormalized());
  return makeTransform(Eigen::Quaterniond(rotation), Eigen::Vector3d(shift[0], shift[1], shift[2]));
}

std::optional<RigidTransform> poseBoard(const camera::CameraModel& camera,
                                        std::span<const Eigen::Vector3d> board, const Sighting& sighting) {
  std::vector<cv::Point3d> points;
  std::vector<cv::Point2d> straight;
  for (const auto& seen : sighting) {
    const auto direction = camera.unproject(seen.pixel);
    if (!direction) return std::nullopt;
    const Eigen::Vector3d& p_M = board[static_cast<std::size_t>(seen.point)];
    points.emplace_back(p_M.x(), p_M.y(), p_M.z());
    straight.emplace_back(direction->x(), direction->y());
  }
  cv::Vec3d turn, shift;
  try {
    if (!cv::solvePnP(points, straight, cv::Matx33d::eye(), cv::noArray(), turn, shift, false,
                      cv::SOLVEPNP_IPPE))
      return std::nullopt;
  } catch (const cv::Exception&) {
    return std::nullopt;
  }
  const auto X_CM = fromRodrigues(turn, shift);
  return isRigid(X_CM) ? std::optional(X_CM) : std::nullopt;
}

std::optional<Bundle> startFrom(const camera::Intrinsics& lens, std::span<const Eigen::Vector3d> board,
                                std::span<const BoardView> views) {
  Bundle start;
  start.cameras = {lens};
  for (const auto& view : views) {
    const auto X_CM = poseBoard(camera::CameraModel(lens), board, view.seen[0]);
    if (!X_CM) return std::nullopt;
    start.X_CM.push_back(*X_CM);
  }
  return start;
}

std::vector<BoardView> ofSecondCamera(std::span<const BoardView> views) {
  std::vector<BoardView> second;
  for (const auto& view : views) second.push_back({view.name, {view.seen[1], {}}});
  return second;
}

double distance_m(const RigidTransform& a, const RigidTransform& b) {
  return (a.translation() - b.translation()).norm() + kTurnLength_m * angleBetween(a, b);
}

/// Every view gives a bar; the one nearest to all others is taken, so that a bad view does no harm.
RigidTransform agreedBar(std::span<const RigidTransform> left, std::span<const RigidTransform> right) {
  std::vector<RigidTransform> bars;
  for (std::size_t i = 0; i < left.size(); ++i) bars.push_back(right[i] * left[i].inverse());
  RigidTransform best = bars.front();
  double least = std::numeric_limits<double>::max();
  for (const auto& candidate : bars) {
    double sum = 0.0;
    for (const auto& other : bars) sum += distance_m(candidate, other);
    if (sum >= least) continue;
    least = sum;
    best = candidate;
  }
  return best;
}

}  // namespace

std::optional<BundleFit> fitCamera(std::span<const Eigen::Vector3d> board, std::span<const BoardView> views,
                                   ImageSize size, camera::LensModel model) {
  std::optional<BundleFit> best;
  for (const double angle_rad : kAngles_rad) {
    const auto start = startFrom(plainLens(size, model, angle_rad), board, views);
    if (!start) continue;
    auto fit = adjustBundle(*start, board, views);
    if (fit && (!best || fit->rms_px < best->rms_px)) best = std::move(fit);
  }
  return best;
}

std::optional<BundleFit> fitRig(std::span<const Eigen::Vector3d> board, std::span<const BoardView> views,
                                ImageSize size, camera::LensModel model) {
  const auto left = fitCamera(board, views, size, model);
  if (!left) return std::nullopt;
  const auto right = fitCamera(board, ofSecondCamera(views), size, model);
  if (!right) return std::nullopt;
  Bundle start;
  start.cameras = {left->bundle.cameras[0], right->bundle.cameras[0]};
  start.X_RC = agreedBar(left->bundle.X_CM, right->bundle.X_CM);
  start.X_CM = left->bundle.X_CM;
  return adjustBundle(start, board, views);
}

}  // namespace mirrorarm::calibration
