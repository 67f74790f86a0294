#include "core/calibration/hold_out.h"

#include <cmath>
#include <optional>
#include <vector>

#include <Eigen/Dense>

#include "core/calibration/board_pose.h"
#include "core/geometry/small_motion.h"

namespace mirrorarm::calibration {
namespace {

using camera::CameraModel;

/// A raw pixel's point on the plane z = 1 and how it moves with the pixel.
struct Straight {
  Eigen::Vector3d ray;
  CameraModel::UnprojectJacobian by_pixel;
};

std::optional<Straight> straight(const CameraModel& camera, const Eigen::Vector2d& pixel) {
  Straight point;
  const auto u = camera.unproject(pixel, point.by_pixel);
  if (!u) return std::nullopt;
  point.ray = u->homogeneous();
  return point;
}

Eigen::Matrix3d essential(const RigidTransform& X_RC) {
  return crossMatrix(X_RC.translation()) * X_RC.linear();
}

/// Distance in pixels to first order: the constraint's value over its slope by the pixel.
double distance_px(double value, const Eigen::Vector3d& line,
                   const CameraModel::UnprojectJacobian& by_pixel) {
  return value / (by_pixel.transpose() * line.head<2>()).norm();
}

/// Where two rays come nearest to each other, in the left camera.
Eigen::Vector3d triangulate(const RigidTransform& X_RC, const Eigen::Vector3d& left,
                            const Eigen::Vector3d& right) {
  const RigidTransform X_CR = X_RC.inverse();
  Eigen::Matrix<double, 3, 2> rays;
  rays << left, -(X_CR.linear() * right);
  const Eigen::Vector2d depths = rays.colPivHouseholderQr().solve(X_CR.translation());
  return 0.5 * (depths[0] * left + X_CR * Eigen::Vector3d(depths[1] * right));
}

using Points = std::vector<std::optional<Eigen::Vector3d>>;

/// Both images of one point on their planes z = 1.
struct StraightPair {
  std::size_t point;
  Straight left, right;
};

std::vector<StraightPair> straightPairs(const camera::StereoRig& rig, const BoardView& view) {
  std::vector<StraightPair> pairs;
  for (const auto& [seen_left, seen_right] : seenByBoth(view)) {
    const auto left = straight(rig.left, seen_left.pixel);
    const auto right = straight(rig.right, seen_right.pixel);
    if (left && right) pairs.push_back({static_cast<std::size_t>(seen_left.point), *left, *right});
  }
  return pairs;
}

double epipolarSquares(const Eigen::Matrix3d& E, const StraightPair& pair) {
  const double value = pair.right.ray.dot(E * pair.left.ray);
  return std::pow(distance_px(value, E * pair.left.ray, pair.right.by_pixel), 2) +
         std::pow(distance_px(value, E.transpose() * pair.right.ray, pair.left.by_pixel), 2);
}

double rootOfMean(double squares, std::size_t count) {
  return count > 0 ? std::sqrt(squares / static_cast<double>(count)) : 0.0;
}

}  // namespace

void HoldOutMeter::addPoints(const camera::StereoRig& rig, const Board& board, const BoardView& centres,
                             const RigidTransform& X_CM) {
  const auto truth = boardPoints(board);
  const Eigen::Matrix3d E = essential(rig.X_RC);
  Points points(truth.size());
  for (const auto& pair : straightPairs(rig, centres)) {
    epipolar_squares_ += epipolarSquares(E, pair);
    epipolar_count_ += 2;
    const Eigen::Vector3d p_C = triangulate(rig.X_RC, pair.left.ray, pair.right.ray);
    depth_squares_ += std::pow(pair.left.ray.normalized().dot(p_C - X_CM * truth[pair.point]), 2);
    ++depths_;
    points[pair.point] = p_C;
  }
  for (const auto& [i, j] : boardNeighbours(board))
    if (points[i] && points[j])
      lengths_.push_back((*points[i] - *points[j]).norm() / (truth[i] - truth[j]).norm() - 1.0);
}

void HoldOutMeter::add(const camera::StereoRig& rig, const Board& board, const BoardView& view) {
  const auto pose = poseBoard(rig, board, view);
  if (!pose) return;
  const std::size_t count = view.seen[0].size() + view.seen[1].size();
  pixel_squares_ += pose->rms_px * pose->rms_px * static_cast<double>(count);
  pixels_ += count;
  ++views_;
  if (!view.seen[1].empty()) addPoints(rig, board, pose->centres, pose->X_CM);
}

HoldOut HoldOutMeter::figures() const {
  HoldOut result;
  result.views = views_;
  result.reprojection_px = rootOfMean(pixel_squares_, pixels_);
  result.epipolar_px = rootOfMean(epipolar_squares_, epipolar_count_);
  result.depth_rms_m = rootOfMean(depth_squares_, depths_);
  if (lengths_.empty()) return result;
  const Eigen::Map<const Eigen::ArrayXd> lengths(lengths_.data(), static_cast<Eigen::Index>(lengths_.size()));
  result.square_mean_percent = 100.0 * lengths.mean();
  result.square_std_percent = 100.0 * std::sqrt((lengths - lengths.mean()).square().mean());
  return result;
}

HoldOut measureHoldOut(const camera::StereoRig& rig, const Board& board, std::span<const BoardView> views) {
  HoldOutMeter meter;
  for (const auto& view : views) meter.add(rig, board, view);
  return meter.figures();
}

}  // namespace mirrorarm::calibration
