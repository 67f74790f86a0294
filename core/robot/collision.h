#pragma once

#include <memory>
#include <optional>
#include <span>

#include "core/robot/arm_description.h"
#include "core/robot/contact.h"
#include "core/robot/obstacle.h"

namespace mirrorarm::robot {

/// Whether the shapes of one arm touch each other or an obstacle, by exact distances of capsules and rounded
/// boxes. Shapes on the same link or on neighbouring links are not compared: they always touch. The base
/// stands still and is not compared with obstacles. One thread: it keeps work space.
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

  /// The first contact on the straight joint motion, its ends included. Steps are as long as the distances
  /// prove to be clear, so nothing is jumped; where shapes are so near that no joint could move by
  /// `finest_rad` without proof, steps are of that size. Source: conservative advancement, Mirtich 1996.
  [[nodiscard]] std::optional<Contact> firstContact(const Joints& from, const Joints& to,
                                                    double finest_rad) const;

 private:
  struct Body;
  std::unique_ptr<Body> body_;
};

}  // namespace mirrorarm::robot
