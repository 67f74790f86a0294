#pragma once

#include <Eigen/Core>

#include "core/geometry/rigid_transform.h"
#include "core/simulation/arm_motion.h"

namespace mirrorarm::simulation {

/// A flat bright piece of the world: a disc, a strip of tape, a reflection.
struct Patch {
  enum class Outline { kEllipse, kRectangle };
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< in the frame that the caller says [m]
  Eigen::Vector3d u = Eigen::Vector3d::UnitX();      ///< from the centre to the rim, one way [m]
  Eigen::Vector3d v = Eigen::Vector3d::UnitY();      ///< and the other, at right angles; u x v looks outwards
  Outline outline = Outline::kEllipse;
  bool retroreflective = true;  ///< sends the ring light back; false: a glow, equally bright from all sides
  double strength = 1.0;        ///< against fresh marker film
};

/// The disc as a patch, in the disc's own frame.
[[nodiscard]] Patch patchOf(const Disc& disc);

[[nodiscard]] Patch transformed(const RigidTransform& X_AB, const Patch& patch_B);

/// The point of the outline at `turn` 0..1 around it, and its derivative by `turn`.
struct OutlinePoint {
  Eigen::Vector3d p;
  Eigen::Vector3d dp;
};
[[nodiscard]] OutlinePoint outlineAt(const Patch& patch, double turn);

}  // namespace mirrorarm::simulation
