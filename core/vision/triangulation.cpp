#include "core/vision/triangulation.h"

#include <Eigen/Dense>

namespace mirrorarm::vision {
namespace {

constexpr int kRounds = 5;
constexpr double kLeastVariance_px2 = 1e-6;

/// The middle of the shortest way between the two rays.
std::optional<Eigen::Vector3d> betweenRays(const camera::StereoRig& rig, const DetectedMarker& left,
                                           const DetectedMarker& right) {
  const auto l = rig.left.unproject(left.centre_px);
  const auto r = rig.right.unproject(right.centre_px);
  if (!l || !r) return std::nullopt;
  const RigidTransform X_CR = rig.X_RC.inverse();
  const Eigen::Vector3d u = Eigen::Vector3d(l->x(), l->y(), 1.0).normalized();
  const Eigen::Vector3d v = X_CR.linear() * Eigen::Vector3d(r->x(), r->y(), 1.0).normalized();
  const Eigen::Vector3d base = X_CR.translation();
  const double cosine = u.dot(v);
  const double sine2 = 1.0 - cosine * cosine;
  if (sine2 < 1e-10) return std::nullopt;
  const double along_u = (base.dot(u) - cosine * base.dot(v)) / sine2;
  const double along_v = (cosine * base.dot(u) - base.dot(v)) / sine2;
  if (along_u <= 0.0 || along_v <= 0.0) return std::nullopt;
  return 0.5 * (along_u * u + base + along_v * v);
}

/// Normal equations of one camera's two residuals.
struct Normals {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  Eigen::Vector3d vector = Eigen::Vector3d::Zero();
};

bool add(Normals& normals, const camera::CameraModel& camera, const RigidTransform& X_KC,
         const Eigen::Vector3d& p_C, const DetectedMarker& marker) {
  camera::CameraModel::ProjectJacobian J;
  const auto pixel = camera.project(X_KC * p_C, J);
  if (!pixel) return false;
  J = J * X_KC.linear();
  const Eigen::Matrix2d weight =
      (marker.covariance_px2 + kLeastVariance_px2 * Eigen::Matrix2d::Identity()).inverse();
  normals.matrix += J.transpose() * weight * J;
  normals.vector += J.transpose() * weight * (marker.centre_px - *pixel);
  return true;
}

}  // namespace

std::optional<TriangulatedPoint> triangulate(const camera::StereoRig& rig, const DetectedMarker& left,
                                             const DetectedMarker& right) {
  const auto start = betweenRays(rig, left, right);
  if (!start) return std::nullopt;
  TriangulatedPoint point{*start, Eigen::Matrix3d::Zero()};
  for (int round = 0; round < kRounds; ++round) {
    Normals normals;
    if (!add(normals, rig.left, RigidTransform::Identity(), point.p_C, left) ||
        !add(normals, rig.right, rig.X_RC, point.p_C, right))
      return std::nullopt;
    point.covariance_m2 = normals.matrix.inverse();
    const Eigen::Vector3d step = point.covariance_m2 * normals.vector;
    point.p_C += step;
    if (step.norm() < 1e-9) break;
  }
  if (!point.p_C.allFinite() || !point.covariance_m2.allFinite()) return std::nullopt;
  return point;
}

}  // namespace mirrorarm::vision
