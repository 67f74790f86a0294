#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/camera/lens.h"
#include "core/camera/radial_polynomial.h"

namespace mirrorarm::camera::kannala_brandt {
namespace {

RadialPolynomial radial(const Distortion& d) { return {{d[0], d[1], d[2], d[3]}}; }

}  // namespace

double limit(const Distortion& d) { return std::min(radial(d).turningRadius(), std::numbers::pi); }

std::optional<Eigen::Vector2d> bend(const Distortion& d, double limit, const Eigen::Vector3d& p_C,
                                    BendJacobian* J) {
  const auto polynomial = radial(d);
  const double r = std::hypot(p_C.x(), p_C.y());
  const double distance2 = p_C.squaredNorm();
  const double angle = std::atan2(r, p_C.z());
  if (!std::isfinite(distance2) || distance2 <= 0.0 || angle > limit || angle >= std::numbers::pi)
    return std::nullopt;
  const bool on_axis = r <= 1e-12 * p_C.z();
  const double scale = on_axis ? 1.0 / p_C.z() : polynomial.value(angle) / r;
  if (J != nullptr) {
    const Eigen::Vector2d outward = on_axis ? Eigen::Vector2d::UnitX() : Eigen::Vector2d(p_C.head<2>() / r);
    const double slope = polynomial.slope(angle);
    J->leftCols<2>() = scale * Eigen::Matrix2d::Identity() +
                       (slope * p_C.z() / distance2 - scale) * outward * outward.transpose();
    J->col(2) = -slope * r / distance2 * outward;
  }
  return scale * p_C.head<2>();
}

std::optional<Eigen::Vector2d> straighten(const Distortion& d, double limit, const Eigen::Vector2d& bent) {
  const double bent_radius = bent.norm();
  if (!std::isfinite(bent_radius)) return std::nullopt;
  if (bent_radius < 1e-12) return bent;
  const auto angle = radial(d).inverse(bent_radius, limit);
  if (!angle || *angle >= std::numbers::pi / 2.0 - 1e-9) return std::nullopt;
  return bent * (std::tan(*angle) / bent_radius);
}

}  // namespace mirrorarm::camera::kannala_brandt
