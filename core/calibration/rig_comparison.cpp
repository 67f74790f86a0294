#include "core/calibration/rig_comparison.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/calibration/hold_out.h"
#include "core/vision/triangulation.h"

namespace mirrorarm::calibration {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr std::array<double, 3> kDistances_m = {0.3, 0.4, 0.6};

double focalChange(const camera::CameraModel& next, const camera::CameraModel& in_force) {
  const auto& a = next.intrinsics();
  const auto& b = in_force.intrinsics();
  return std::max(std::abs(a.fx_px / b.fx_px - 1.0), std::abs(a.fy_px / b.fy_px - 1.0));
}

/// Nothing where one rig sees the point and the other sees none there.
double depthChange(const camera::StereoRig& next, const camera::StereoRig& in_force, double distance_m) {
  const auto images = vision::imaged(next, {0.0, 0.0, distance_m});
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  if (!images) return kNone;
  vision::DetectedMarker left, right;
  left.centre_px = images->left.pixel;
  right.centre_px = images->right.pixel;
  left.covariance_px2 = right.covariance_px2 = Eigen::Matrix2d::Identity();
  const auto point = vision::triangulate(in_force, left, right);
  return point ? point->p_C.z() / distance_m - 1.0 : kNone;
}

}  // namespace

RigComparison compareRigs(const camera::StereoRig& next, const camera::StereoRig& in_force,
                          const Board& board, std::span<const BoardView> views) {
  RigComparison result;
  result.turn_deg = kDegrees * angleBetween(next.X_RC, in_force.X_RC);
  result.shift_mm = 1e3 * (next.X_RC.inverse().translation() - in_force.X_RC.inverse().translation()).norm();
  result.focal_percent =
      100.0 * std::max(focalChange(next.left, in_force.left), focalChange(next.right, in_force.right));
  result.epipolar_new_px = measureHoldOut(next, board, views).epipolar_px;
  result.epipolar_old_px = measureHoldOut(in_force, board, views).epipolar_px;
  for (std::size_t i = 0; i < kDistances_m.size(); ++i)
    result.depth[i] = {kDistances_m[i], 100.0 * depthChange(next, in_force, kDistances_m[i])};
  return result;
}

}  // namespace mirrorarm::calibration
