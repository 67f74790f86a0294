#include "core/vision/epipolar_geometry.h"

#include <cmath>

#include <Eigen/Geometry>

namespace mirrorarm::vision {

EpipolarGeometry::EpipolarGeometry(const camera::StereoRig& rig) : left_(rig.left), right_(rig.right) {
  const Eigen::Matrix3d R_CR = rig.X_RC.linear().transpose();
  const Eigen::Vector3d along = (-(R_CR * rig.X_RC.translation())).normalized();
  const Eigen::Vector3d forward = Eigen::Vector3d::UnitZ() + R_CR.col(2);
  const Eigen::Vector3d down = forward.cross(along).normalized();
  R_EC_ << along.transpose(), down.transpose(), along.cross(down).transpose();
  R_ER_ = R_EC_ * R_CR;
  const auto& l = rig.left.intrinsics();
  const auto& r = rig.right.intrinsics();
  focal_px_ = 0.25 * (l.fx_px + l.fy_px + r.fx_px + r.fy_px);
  baseline_m_ = rig.X_RC.translation().norm();
}

std::optional<RectifiedPoint> EpipolarGeometry::rectify(const camera::CameraModel& camera,
                                                        const Eigen::Matrix3d& R,
                                                        const Eigen::Vector2d& pixel) const {
  camera::CameraModel::UnprojectJacobian by_pixel;
  const auto point = camera.unproject(pixel, by_pixel);
  if (!point) return std::nullopt;
  const Eigen::Vector3d ray = R * point->homogeneous();
  if (!(ray.z() > 1e-3 * ray.norm())) return std::nullopt;
  const Eigen::Vector2d slope = ray.head<2>() / ray.z();
  const Eigen::RowVector2d row_by_point = (R.block<1, 2>(1, 0) - slope.y() * R.block<1, 2>(2, 0)) / ray.z();
  return RectifiedPoint{focal_px_ * slope, focal_px_ * row_by_point * by_pixel};
}

std::optional<RectifiedPoint> EpipolarGeometry::left(const Eigen::Vector2d& pixel) const {
  return rectify(left_, R_EC_, pixel);
}

std::optional<RectifiedPoint> EpipolarGeometry::right(const Eigen::Vector2d& pixel) const {
  return rectify(right_, R_ER_, pixel);
}

double EpipolarGeometry::epipolarDistance_px(const RectifiedPoint& left, const RectifiedPoint& right) {
  return std::abs(left.rectified_px.y() - right.rectified_px.y()) / right.row_by_pixel.norm();
}

Eigen::Vector3d EpipolarGeometry::pointOf(const RectifiedPoint& left, const RectifiedPoint& right) const {
  const double disparity_px = left.rectified_px.x() - right.rectified_px.x();
  const double row_px = 0.5 * (left.rectified_px.y() + right.rectified_px.y());
  const Eigen::Vector3d p_E(left.rectified_px.x(), row_px, focal_px_);
  return baseline_m_ / disparity_px * (R_EC_.transpose() * p_E);
}

}  // namespace mirrorarm::vision
