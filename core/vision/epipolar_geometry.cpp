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
}

std::optional<RectifiedPoint> EpipolarGeometry::rectify(const camera::CameraModel& camera,
                                                        const Eigen::Matrix3d& R,
                                                        const Eigen::Vector2d& pixel) const {
  const auto point = camera.unproject(pixel);
  if (!point) return std::nullopt;
  const Eigen::Vector3d ray = R * Eigen::Vector3d(point->x(), point->y(), 1.0).normalized();
  if (!(ray.z() > 1e-3)) return std::nullopt;
  return RectifiedPoint{ray, focal_px_ / ray.z() * ray.head<2>()};
}

std::optional<RectifiedPoint> EpipolarGeometry::left(const Eigen::Vector2d& pixel) const {
  return rectify(left_, R_EC_, pixel);
}

std::optional<RectifiedPoint> EpipolarGeometry::right(const Eigen::Vector2d& pixel) const {
  return rectify(right_, R_ER_, pixel);
}

double EpipolarGeometry::epipolarDistance_px(const RectifiedPoint& left, const RectifiedPoint& right) const {
  const Eigen::Vector2d normal = Eigen::Vector2d(-left.ray.z(), left.ray.y()).normalized();
  return focal_px_ * std::abs(normal.x() * right.ray.y() + normal.y() * right.ray.z());
}

}  // namespace mirrorarm::vision
