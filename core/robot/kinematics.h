#pragma once

#include <memory>
#include <optional>

#include "core/geometry/rigid_transform.h"
#include "core/robot/arm_description.h"
#include "core/robot/posture_choice.h"

namespace mirrorarm::robot {

/// Forward and inverse kinematics of one arm (KDL inside, closed form where the arm allows it). Not shared
/// between threads: it keeps work space.
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

  /// Joints within the arm's ranges that bring the flange to `X_BF` and continue `seed`: what the arm
  /// follows. Arms like the LBR are answered in closed form (see PostureChoice; 1e-9 m and rad, no heap, no
  /// state), others by damped Newton steps near the seed (0.1 mm, 0.1 mrad; every failure is called
  /// kOutOfReach).
  [[nodiscard]] Expected<Joints, NoPosture> follow(const RigidTransform& X_BF, const Joints& seed) const;
  /// The same, where the reason does not matter.
  [[nodiscard]] std::optional<Joints> inverse(const RigidTransform& X_BF, const Joints& seed) const;
  /// Any joints within the ranges that bring the flange there, rather near `seed`: where the arm travels to.
  [[nodiscard]] Expected<Joints, NoPosture> reach(const RigidTransform& X_BF, const Joints& seed) const;

 private:
  struct Body;
  std::unique_ptr<Body> body_;
};

}  // namespace mirrorarm::robot
