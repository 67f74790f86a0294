#include "core/simulation/patch.h"

#include <cmath>
#include <numbers>

namespace mirrorarm::simulation {
namespace {

OutlinePoint ellipseAt(const Patch& patch, double turn) {
  constexpr double kFull = 2.0 * std::numbers::pi;
  const double c = std::cos(kFull * turn), s = std::sin(kFull * turn);
  return {patch.centre + c * patch.u + s * patch.v, kFull * (c * patch.v - s * patch.u)};
}

/// The four sides take a quarter turn each.
OutlinePoint rectangleAt(const Patch& patch, double turn) {
  const double quarters = 4.0 * turn;
  const int side = static_cast<int>(quarters) % 4;
  const double along = 2.0 * (quarters - std::floor(quarters)) - 1.0;
  const double sign = side < 2 ? 1.0 : -1.0;
  if (side % 2 == 0) return {patch.centre + sign * (patch.u + along * patch.v), 8.0 * sign * patch.v};
  return {patch.centre + sign * (patch.v - along * patch.u), -8.0 * sign * patch.u};
}

}  // namespace

Patch patchOf(const Disc& disc) {
  const Eigen::Vector3d normal = disc.normal_B.normalized();
  const Eigen::Vector3d u = normal.unitOrthogonal();
  const double radius = 0.5 * disc.diameter_m;
  return {disc.p_B, radius * u, radius * normal.cross(u), Patch::Outline::kEllipse, true, 1.0};
}

Patch transformed(const RigidTransform& X_AB, const Patch& patch_B) {
  Patch patch = patch_B;
  patch.centre = X_AB * patch_B.centre;
  patch.u = X_AB.linear() * patch_B.u;
  patch.v = X_AB.linear() * patch_B.v;
  return patch;
}

OutlinePoint outlineAt(const Patch& patch, double turn) {
  return patch.outline == Patch::Outline::kEllipse ? ellipseAt(patch, turn) : rectangleAt(patch, turn);
}

}  // namespace mirrorarm::simulation
