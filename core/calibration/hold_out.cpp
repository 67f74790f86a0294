#include "core/calibration/hold_out.h"

#include <cmath>
#include <optional>
#include <vector>

#include <Eigen/Dense>

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

struct Sums {
  double epipolar_squares = 0.0;
  std::size_t distances = 0;
  std::vector<double> lengths;  ///< measured over true, minus 1
};

using Points = std::vector<std::optional<Eigen::Vector3d>>;

Points measurePoints(const camera::StereoRig& rig, const BoardView& view, std::size_t count, Sums& sums) {
  const Eigen::Matrix3d E = essential(rig.X_RC);
  Points points(count);
  for (const auto& [seen_left, seen_right] : seenByBoth(view)) {
    const auto left = straight(rig.left, seen_left.pixel);
    const auto right = straight(rig.right, seen_right.pixel);
    if (!left || !right) continue;
    const double value = right->ray.dot(E * left->ray);
    sums.epipolar_squares += std::pow(distance_px(value, E * left->ray, right->by_pixel), 2) +
                             std::pow(distance_px(value, E.transpose() * right->ray, left->by_pixel), 2);
    sums.distances += 2;
    points[static_cast<std::size_t>(seen_left.point)] = triangulate(rig.X_RC, left->ray, right->ray);
  }
  return points;
}

void measureLengths(const Points& points, const Board& board, std::span<const Eigen::Vector3d> truth,
                    Sums& sums) {
  for (const auto& [i, j] : boardNeighbours(board))
    if (points[i] && points[j])
      sums.lengths.push_back((*points[i] - *points[j]).norm() / (truth[i] - truth[j]).norm() - 1.0);
}

}  // namespace

HoldOut measureHoldOut(const camera::StereoRig& rig, const Board& board, std::span<const BoardView> views) {
  Sums sums;
  const auto truth = boardPoints(board);
  for (const auto& view : views)
    measureLengths(measurePoints(rig, view, truth.size(), sums), board, truth, sums);
  HoldOut result;
  result.views = views.size();
  if (sums.distances == 0) return result;
  result.epipolar_px = std::sqrt(sums.epipolar_squares / static_cast<double>(sums.distances));
  if (sums.lengths.empty()) return result;
  const Eigen::Map<const Eigen::ArrayXd> lengths(sums.lengths.data(),
                                                 static_cast<Eigen::Index>(sums.lengths.size()));
  result.square_mean_percent = 100.0 * lengths.mean();
  result.square_std_percent = 100.0 * std::sqrt((lengths - lengths.mean()).square().mean());
  return result;
}

}  // namespace mirrorarm::calibration
