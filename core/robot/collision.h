#pragma once

#include <memory>
#include <optional>
#include <span>

#include "core/robot/arm_description.h"
#include "core/robot/contact.h"
#include "core/robot/obstacle.h"

namespace mirrorarm::robot {

/// Whether the shapes of one arm touch each other or an obstacle (FCL inside). Shapes on the same link or on
/// neighbouring links are not compared: they always touch. The base stands still and is not compared with
/// obstacles. One thread: it keeps work space.
class CollisionWorld {
 public:
  /// `attached` are shapes fixed to the flange (link = jointCount()): camera bar, sling.
  CollisionWorld(const ArmDescription& arm, std::span<const Capsule> attached,
                 std::span<const Obstacle> obstacles);
  ~CollisionWorld();
  CollisionWorld(CollisionWorld&&) noexcept;
  CollisionWorld& operator=(CollisionWorld&&) noexcept;

  [[nodiscard]] bool collides(const Joints& q) const { return contact(q).has_value(); }
  /// What meets what there; of several the first found.
  [[nodiscard]] std::optional<Contact> contact(const Joints& q) const;

 private:
  struct Body;
  std::unique_ptr<Body> body_;
};

}  // namespace mirrorarm::robot
