#include "core/vision/triangulation.h"

#include <Eigen/Dense>

#include "core/vision/epipolar_geometry.h"

namespace mirrorarm::vision {
namespace {

constexpr int kRounds = 4;
constexpr double kLeastVariance_px2 = 1e-8;

std::optional<PointImage> imagedBy(const camera::CameraModel& camera, const Eigen::Vector3d& p_K) {
  PointImage image;
  const auto pixel = camera.project(p_K, image.by_point);
  if (!pixel) return std::nullopt;
  image.pixel = *pixel;
  return image;
}

}  // namespace

std::optional<ImagedPoint> imaged(const camera::StereoRig& rig, const Eigen::Vector3d& p_C) {
  const auto left = imagedBy(rig.left, p_C);
  auto right = imagedBy(rig.right, rig.X_RC * p_C);
  if (!left || !right) return std::nullopt;
  right->by_point = (right->by_point * rig.X_RC.linear()).eval();
  return ImagedPoint{p_C, *left, *right};
}

MeasuredCentre measuredCentre(const Eigen::Vector2d& pixel, const Eigen::Matrix2d& covariance_px2) {
  return {pixel, (covariance_px2 + kLeastVariance_px2 * Eigen::Matrix2d::Identity()).inverse()};
}

TriangulatedPoint stepTowards(const ImagedPoint& near, const MeasuredCentre& left,
                              const MeasuredCentre& right) {
  const Eigen::Matrix<double, 3, 2> pull_left = near.left.by_point.transpose() * left.weight_px2;
  const Eigen::Matrix<double, 3, 2> pull_right = near.right.by_point.transpose() * right.weight_px2;
  TriangulatedPoint point;
  point.covariance_m2 = (pull_left * near.left.by_point + pull_right * near.right.by_point).inverse();
  point.p_C = near.p_C + point.covariance_m2 * (pull_left * (left.pixel - near.left.pixel) +
                                                pull_right * (right.pixel - near.right.pixel));
  return point;
}

std::optional<TriangulatedPoint> triangulate(const camera::StereoRig& rig, const DetectedMarker& left,
                                             const DetectedMarker& right) {
  const EpipolarGeometry geometry(rig);
  const auto l = geometry.left(left.centre_px);
  const auto r = geometry.right(right.centre_px);
  if (!l || !r || !(l->rectified_px.x() > r->rectified_px.x())) return std::nullopt;
  const auto left_centre = measuredCentre(left.centre_px, left.covariance_px2);
  const auto right_centre = measuredCentre(right.centre_px, right.covariance_px2);
  TriangulatedPoint point{geometry.pointOf(*l, *r), Eigen::Matrix3d::Zero()};
  for (int round = 0; round < kRounds; ++round) {
    const auto images = imaged(rig, point.p_C);
    if (!images) return std::nullopt;
    point = stepTowards(*images, left_centre, right_centre);
  }
  if (!point.p_C.allFinite() || !point.covariance_m2.allFinite()) return std::nullopt;
  return point;
}

}  // namespace mirrorarm::vision
