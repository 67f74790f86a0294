#pragma once

#include <memory>
#include <span>

#include "core/robot/arm_description.h"

namespace mirrorarm::robot {

struct Obstacle;

/// Whether the shapes of one arm touch each other or an obstacle (FCL inside). Shapes on the same link or on
/// neighbouring links are not compared: they always touch. The base stands still and is not compared with
/// obstacles. One thread: it keeps work space.
class CollisionWorld {
 public:
  CollisionWorld(const ArmDescription& arm, std::span<const Capsule> attached,
                 std::span<const Obstacle> obstacles);
  ~CollisionWorld();

  [[nodiscard]] bool collides(const Joints& q) const;

 private:
  struct Body;
  std::unique_ptr<Body> body_;
};

}  // namespace mirrorarm::robot
