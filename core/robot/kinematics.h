#pragma once

#include <memory>
#include <optional>

#include "core/geometry/rigid_transform.h"
#include "core/robot/arm_description.h"

namespace mirrorarm::robot {

/// Forward and inverse kinematics of one arm (KDL inside). Not shared between threads: it keeps work space.
class Kinematics {
 public:
  explicit Kinematics(const ArmDescription& arm);
  ~Kinematics();
  Kinematics(Kinematics&&) noexcept;
  Kinematics& operator=(Kinematics&&) noexcept;

  [[nodiscard]] int jointCount() const;
  /// Flange in base. Does not allocate.
  [[nodiscard]] RigidTransform flange(const Joints& q) const;
  /// Frame of the link after joint `link` (0 the base, jointCount() the last) in base. Does not allocate.
  [[nodiscard]] RigidTransform link(const Joints& q, int link) const;
  [[nodiscard]] Jacobian jacobian(const Joints& q) const;

  /// Joints near `seed`, within the arm's limits, that bring the flange to `X_BF` (0.1 mm, 0.1 mrad).
  /// Nothing when out of reach or not found.
  [[nodiscard]] std::optional<Joints> inverse(const RigidTransform& X_BF, const Joints& seed) const;

 private:
  struct Body;
  std::unique_ptr<Body> body_;
};

}  // namespace mirrorarm::robot
