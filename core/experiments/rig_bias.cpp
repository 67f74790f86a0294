#include "core/experiments/rig_bias.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

#include "core/geometry/rigid_fit.h"
#include "core/vision/triangulation.h"

namespace mirrorarm::experiments {
namespace {

vision::DetectedMarker centreAt(const std::optional<Eigen::Vector2d>& pixel) {
  assert(pixel);
  vision::DetectedMarker marker;
  marker.centre_px = *pixel;
  marker.covariance_px2 = Eigen::Matrix2d::Identity();
  return marker;
}

}  // namespace

std::vector<Eigen::Vector3d> paperCuboid_C(const camera::StereoRig& rig) {
  constexpr double kStep_m = 0.02, kDistance_m = 0.4;
  const Eigen::Vector3d middle_C =
      0.5 * rig.X_RC.inverse().translation() + kDistance_m * Eigen::Vector3d::UnitZ();
  std::vector<Eigen::Vector3d> points;
  for (const double z : {-1.0, 0.0, 1.0})
    for (const double y : {-1.5, -0.5, 0.5, 1.5})
      for (const double x : {-1.5, -0.5, 0.5, 1.5})
        points.push_back(middle_C + kStep_m * Eigen::Vector3d(x, y, z));
  return points;
}

RigBias biasOf(const camera::StereoRig& calibrated, const camera::StereoRig& truth,
               std::span<const Eigen::Vector3d> points_C) {
  std::vector<Eigen::Vector3d> measured_C;
  RigBias bias;
  double squares = 0.0;
  for (const auto& p_C : points_C) {
    const auto point = vision::triangulate(calibrated, centreAt(truth.left.project(p_C)),
                                           centreAt(truth.right.project(truth.X_RC * p_C)));
    assert(point);
    measured_C.push_back(point->p_C);
    const double error_mm = 1e3 * (point->p_C - p_C).norm();
    squares += error_mm * error_mm / static_cast<double>(points_C.size());
    bias.largest_mm = std::max(bias.largest_mm, error_mm);
  }
  bias.rms_mm = std::sqrt(squares);
  bias.shape_rms_mm = 1e3 * fitRms(fitByKabsch(measured_C, points_C), measured_C, points_C);
  return bias;
}

}  // namespace mirrorarm::experiments
