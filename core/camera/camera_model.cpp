#include "core/camera/camera_model.h"

#include <Eigen/LU>

#include "core/camera/lens.h"

namespace mirrorarm::camera {
namespace {

Eigen::Array2d focal(const Intrinsics& i) { return {i.fx_px, i.fy_px}; }
Eigen::Array2d centre(const Intrinsics& i) { return {i.cx_px, i.cy_px}; }

std::optional<Eigen::Vector2d> projectWith(const Intrinsics& i, double limit, const Eigen::Vector3d& p_C,
                                           BendJacobian* J) {
  const auto bent = i.model == LensModel::kBrownConrady ? brown_conrady::bend(i.distortion, limit, p_C, J)
                                                        : kannala_brandt::bend(i.distortion, limit, p_C, J);
  if (!bent) return std::nullopt;
  if (J != nullptr) *J = focal(i).matrix().asDiagonal() * *J;
  return (bent->array() * focal(i) + centre(i)).matrix();
}

}  // namespace

std::string_view name(LensModel model) {
  return model == LensModel::kBrownConrady ? "brown_conrady" : "kannala_brandt";
}

std::optional<LensModel> lensModelOf(std::string_view text) {
  for (const auto model : {LensModel::kBrownConrady, LensModel::kKannalaBrandt})
    if (text == name(model)) return model;
  return std::nullopt;
}

CameraModel::CameraModel(const Intrinsics& intrinsics)
    : intrinsics_(intrinsics),
      max_radius_(intrinsics.model == LensModel::kBrownConrady
                      ? brown_conrady::limit(intrinsics.distortion)
                      : kannala_brandt::limit(intrinsics.distortion)) {}

std::optional<Eigen::Vector2d> CameraModel::project(const Eigen::Vector3d& p_C) const {
  return projectWith(intrinsics_, max_radius_, p_C, nullptr);
}

std::optional<Eigen::Vector2d> CameraModel::project(const Eigen::Vector3d& p_C, ProjectJacobian& J) const {
  return projectWith(intrinsics_, max_radius_, p_C, &J);
}

std::optional<Eigen::Vector2d> CameraModel::unproject(const Eigen::Vector2d& pixel) const {
  const Eigen::Vector2d bent = ((pixel.array() - centre(intrinsics_)) / focal(intrinsics_)).matrix();
  return intrinsics_.model == LensModel::kBrownConrady
             ? brown_conrady::straighten(intrinsics_.distortion, max_radius_, bent)
             : kannala_brandt::straighten(intrinsics_.distortion, max_radius_, bent);
}

std::optional<Eigen::Vector2d> CameraModel::unproject(const Eigen::Vector2d& pixel,
                                                      UnprojectJacobian& J) const {
  const auto point = unproject(pixel);
  if (!point) return std::nullopt;
  ProjectJacobian J_project;
  if (!project(Eigen::Vector3d(point->x(), point->y(), 1.0), J_project)) return std::nullopt;
  J = J_project.leftCols<2>().inverse();
  return point;
}

bool CameraModel::sees(const Eigen::Vector2d& pixel, double margin_px) const {
  return pixel.x() >= margin_px && pixel.x() <= intrinsics_.width_px - 1 - margin_px &&
         pixel.y() >= margin_px && pixel.y() <= intrinsics_.height_px - 1 - margin_px;
}

}  // namespace mirrorarm::camera
