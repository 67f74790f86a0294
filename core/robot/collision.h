#pragma once

#include <memory>
#include <span>

#include "core/robot/arm_description.h"

namespace mirrorarm::robot {

/// A box the arm must not enter, in base frame B.
struct Obstacle {
  RigidTransform X_BO = RigidTransform::Identity();  ///< its centre
  Eigen::Vector3d size_m = Eigen::Vector3d::Ones();
};

/// Whether the shapes of one arm touch each other or an obstacle (FCL inside). Shapes on the same link or on
/// neighbouring links are not compared: they always touch. The base stands still and is not compared with
/// obstacles. One thread: it keeps work space.
class CollisionWorld {
 public:
  /// `attached` are shapes fixed to the flange (link = jointCount()): camera bar, sling.
  CollisionWorld(const ArmDescription& arm, std::span<const Capsule> attached,
                 std::span<const Obstacle> obstacles);
  ~CollisionWorld();

  [[nodiscard]] bool collides(const Joints& q) const;

 private:
  struct Body;
  std::unique_ptr<Body> body_;
};

}  // namespace mirrorarm::robot
