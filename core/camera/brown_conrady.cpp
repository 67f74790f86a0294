#include <cmath>

#include <Eigen/LU>

#include "core/camera/lens.h"
#include "core/camera/radial_polynomial.h"

namespace mirrorarm::camera::brown_conrady {
namespace {

RadialPolynomial radial(const Distortion& d) { return {{d[0], d[1], d[4], 0.0}}; }

Eigen::Vector2d distort(const Distortion& d, const Eigen::Vector2d& u, Eigen::Matrix2d* J) {
  const auto polynomial = radial(d);
  const double r2 = u.squaredNorm();
  const double gain = polynomial.gain(r2);
  const double p1 = d[2];
  const double p2 = d[3];
  const Eigen::Vector2d cross(2.0 * p1 * u.x() * u.y() + p2 * (r2 + 2.0 * u.x() * u.x()),
                              p1 * (r2 + 2.0 * u.y() * u.y()) + 2.0 * p2 * u.x() * u.y());
  if (J != nullptr) {
    const double mixed = 2.0 * (p1 * u.x() + p2 * u.y());
    *J << 2.0 * p1 * u.y() + 6.0 * p2 * u.x(), mixed, mixed, 6.0 * p1 * u.y() + 2.0 * p2 * u.x();
    *J += gain * Eigen::Matrix2d::Identity() + 2.0 * polynomial.gainSlope(r2) * u * u.transpose();
  }
  return gain * u + cross;
}

}  // namespace

double limit(const Distortion& d) { return radial(d).turningRadius(); }

std::optional<Eigen::Vector2d> bend(const Distortion& d, double limit, const Eigen::Vector3d& p_C,
                                    BendJacobian* J) {
  if (!(p_C.z() > 0.0)) return std::nullopt;
  const Eigen::Vector2d u = p_C.head<2>() / p_C.z();
  if (!u.allFinite() || u.norm() > limit) return std::nullopt;
  Eigen::Matrix2d J_u;
  const Eigen::Vector2d bent = distort(d, u, J != nullptr ? &J_u : nullptr);
  if (J != nullptr) {
    J->leftCols<2>() = J_u / p_C.z();
    J->col(2) = -(J_u * u) / p_C.z();
  }
  return bent;
}

std::optional<Eigen::Vector2d> straighten(const Distortion& d, double limit, const Eigen::Vector2d& bent) {
  const double bent_radius = bent.norm();
  if (!std::isfinite(bent_radius)) return std::nullopt;
  if (bent_radius == 0.0 && d[2] == 0.0 && d[3] == 0.0) return bent;
  // The tangential terms are small: from the radial solution Newton's steps in two dimensions need a few
  // rounds. Just beyond the radial curve's reach they may still find a point, hence the start inside the
  // limit.
  const double r = radial(d).inverse(bent_radius, limit).value_or(0.99 * limit);
  Eigen::Vector2d u = bent_radius > 0.0 ? Eigen::Vector2d(bent * (r / bent_radius)) : bent;
  for (int i = 0; i < 30; ++i) {
    Eigen::Matrix2d J;
    const Eigen::Vector2d error = distort(d, u, &J) - bent;
    const Eigen::Vector2d step = J.inverse() * error;
    if (!step.allFinite()) return std::nullopt;
    u -= step;
    if (step.norm() <= 1e-14 * (1.0 + u.norm())) break;
  }
  const bool solved = (distort(d, u, nullptr) - bent).norm() < 1e-11 * (1.0 + bent_radius);
  if (!solved || u.norm() > limit) return std::nullopt;
  return u;
}

}  // namespace mirrorarm::camera::brown_conrady
