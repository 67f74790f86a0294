#pragma once

#include <cmath>
#include <numbers>
#include <optional>
#include <random>
#include <vector>

#include <Eigen/Dense>

#include "core/camera/stereo_rig.h"
#include "core/vision/detected_marker.h"

namespace mirrorarm::vision {

/// A flat disc in the left camera's frame.
struct WorldDisc {
  Eigen::Vector3d p_C = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal_C = -Eigen::Vector3d::UnitZ();
  double radius_m = 0.0035;
};

/// `count` points of the outline, each with the length of its piece of outline; empty outside the lens model.
struct OutlinePiece {
  Eigen::Vector2d pixel;
  double length_px;
};
inline std::vector<OutlinePiece> outlineOf(const camera::CameraModel& camera, const RigidTransform& X_KC,
                                           const WorldDisc& disc, int count) {
  const Eigen::Vector3d u = disc.normal_C.unitOrthogonal();
  const Eigen::Vector3d v = disc.normal_C.cross(u);
  std::vector<OutlinePiece> outline;
  for (int i = 0; i < count; ++i) {
    const double turn = 2.0 * std::numbers::pi * i / count;
    camera::CameraModel::ProjectJacobian J;
    const Eigen::Vector3d rim_C = disc.p_C + disc.radius_m * (std::cos(turn) * u + std::sin(turn) * v);
    const auto pixel = camera.project(X_KC * rim_C, J);
    if (!pixel) return {};
    const Eigen::Vector3d along_C = std::cos(turn) * v - std::sin(turn) * u;
    outline.push_back({*pixel, (J * X_KC.linear() * along_C).norm()});
  }
  return outline;
}

/// The ellipse with the least squared distance from a dense outline, weighted by its length, to 1e-10: slow
/// and sure.
inline Ellipse denseFit(const std::vector<OutlinePiece>& outline) {
  using Vector5d = Eigen::Matrix<double, 5, 1>;
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  for (const auto& piece : outline) centre += piece.pixel / static_cast<double>(outline.size());
  Eigen::Matrix2d axes = Eigen::Matrix2d::Zero();
  for (const auto& piece : outline)
    axes += 2.0 / static_cast<double>(outline.size()) * (piece.pixel - centre) *
            (piece.pixel - centre).transpose();
  axes = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(axes).operatorSqrt();
  for (int round = 0; round < 15; ++round) {
    Eigen::Matrix<double, 5, 5> matrix = Eigen::Matrix<double, 5, 5>::Zero();
    Vector5d vector = Vector5d::Zero();
    const Eigen::Matrix2d inverse = axes.inverse();
    for (const auto& piece : outline) {
      const Eigen::Vector2d u = inverse * (piece.pixel - centre);
      double turn = std::atan2(u.y(), u.x());
      Eigen::Vector2d e, off;
      for (int i = 0; i < 5; ++i) {  // to the nearest point of the ellipse
        e = {std::cos(turn), std::sin(turn)};
        off = piece.pixel - centre - axes * e;
        const Eigen::Vector2d tangent = axes * Eigen::Vector2d(-e.y(), e.x());
        turn += off.dot(tangent) / (tangent.squaredNorm() + off.dot(axes * e));
      }
      const Eigen::Vector2d normal = (inverse.transpose() * e).normalized();
      const Eigen::Vector2d pulled = axes.transpose() * normal;
      Vector5d row;
      row << normal, pulled.x() * e.x(), pulled.y() * e.y(), pulled.x() * e.y() + pulled.y() * e.x();
      matrix += piece.length_px * row * row.transpose();
      vector += piece.length_px * row * off.dot(normal);
    }
    const Vector5d step = matrix.ldlt().solve(vector);
    centre += step.head<2>();
    Eigen::Matrix2d strain;
    strain << step[2], step[4], step[4], step[3];
    axes = axes * (Eigen::Matrix2d::Identity() + strain);
  }
  return ellipseOf(centre, axes * axes.transpose());
}

/// The marker that a fit to the disc's raw outline gives, with `sigma_px` of noise in centre and semi axes.
inline DetectedMarker markerOf(const camera::CameraModel& camera, const RigidTransform& X_KC,
                               const WorldDisc& disc, double sigma_px, std::mt19937& random) {
  std::normal_distribution<double> normal(0.0, 1.0);
  DetectedMarker marker;
  marker.ellipse = denseFit(outlineOf(camera, X_KC, disc, 60));
  marker.ellipse.centre_px += sigma_px * Eigen::Vector2d(normal(random), normal(random));
  const Eigen::Matrix2d shape = shapeOf(marker.ellipse);
  const Eigen::Matrix2d root = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(shape).operatorSqrt();
  Eigen::Matrix2d noisy = shape;
  const double sigmas_px[] = {sigma_px, sigma_px / std::sqrt(2.0), sigma_px};
  for (int i = 0; i < 3; ++i) {  // strains xx, xy, yy: isotropic noise of the outline
    Eigen::Matrix2d strain = Eigen::Matrix2d::Zero();
    strain(i / 2, (i + 1) / 2) = strain((i + 1) / 2, i / 2) = sigmas_px[i];
    const Eigen::Matrix2d change = root * strain + strain * root;
    noisy += normal(random) * change;
    const Eigen::Vector3d packed(change(0, 0), change(0, 1), change(1, 1));
    marker.shape_covariance_px4 += packed * packed.transpose();
  }
  marker.ellipse = ellipseOf(marker.ellipse.centre_px, noisy);
  marker.centre_px = marker.ellipse.centre_px;
  marker.covariance_px2 = sigma_px * sigma_px * Eigen::Matrix2d::Identity();
  marker.outline_fraction = 1.0;
  return marker;
}

/// A normal `tilt_rad` away from looking back along `ray_C`.
inline Eigen::Vector3d tilted(const Eigen::Vector3d& ray_C, double tilt_rad, double azimuth_rad) {
  const Eigen::Vector3d away = ray_C.normalized();
  const Eigen::Vector3d a = away.unitOrthogonal();
  const Eigen::Vector3d b = away.cross(a);
  return std::sin(tilt_rad) * (std::cos(azimuth_rad) * a + std::sin(azimuth_rad) * b) -
         std::cos(tilt_rad) * away;
}

/// Discs scattered before both cameras of a bench rig, faced by both.
inline WorldDisc anyDisc(std::mt19937& random, double depth_m) {
  std::uniform_real_distribution<double> even(0.0, 1.0);
  WorldDisc disc;
  disc.p_C = {0.06 + 0.3 * (even(random) - 0.5), 0.2 * (even(random) - 0.5), depth_m};
  const Eigen::Vector3d ray = disc.p_C - Eigen::Vector3d(0.06, 0.0, 0.0);
  disc.normal_C = tilted(ray, 0.9 * std::sqrt(even(random)), 2.0 * std::numbers::pi * even(random));
  return disc;
}

}  // namespace mirrorarm::vision
