#include "core/vision/fit_plane.h"

#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace mirrorarm::vision {

std::optional<FitPlane> FitPlane::around(const camera::CameraModel* camera, const Eigen::Vector2d& pixel) {
  FitPlane plane;
  if (camera == nullptr) return plane;
  Eigen::Matrix2d J;
  const auto point = camera->unproject(pixel, J);
  if (!point || !J.allFinite()) return std::nullopt;
  const Eigen::Vector3d ray(point->x(), point->y(), 1.0);
  plane.camera_ = camera;
  plane.R_PC_ = Eigen::Quaterniond::FromTwoVectors(ray, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  const double area = std::abs((plane.R_PC_.topLeftCorner<2, 2>() / ray.norm() * J).determinant());
  if (!(area > 0.0)) return std::nullopt;
  plane.scale_px_ = 1.0 / std::sqrt(area);
  return plane;
}

std::optional<Eigen::Vector2d> FitPlane::fromPixel(const Eigen::Vector2d& pixel) const {
  if (camera_ == nullptr) return pixel;
  const auto point = camera_->unproject(pixel);
  if (!point) return std::nullopt;
  const Eigen::Vector3d turned = R_PC_ * Eigen::Vector3d(point->x(), point->y(), 1.0);
  if (!(turned.z() > 0.0)) return std::nullopt;
  return turned.head<2>() * (scale_px_ / turned.z());
}

std::optional<Eigen::Vector2d> FitPlane::toPixel(const Eigen::Vector2d& point, Eigen::Matrix2d& J) const {
  if (camera_ == nullptr) {
    J.setIdentity();
    return point;
  }
  const Eigen::Matrix3d R_CP = R_PC_.transpose();
  camera::CameraModel::ProjectJacobian J_project;
  const auto pixel = camera_->project(R_CP * Eigen::Vector3d(point.x(), point.y(), scale_px_), J_project);
  if (pixel) J = J_project * R_CP.leftCols<2>();
  return pixel;
}

}  // namespace mirrorarm::vision
