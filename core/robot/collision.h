#pragma once

#include <memory>
#include <optional>
#include <span>

#include "core/robot/arm_description.h"
#include "core/robot/contact.h"
#include "core/robot/obstacle.h"
#include "core/robot/safe_distances.h"

namespace mirrorarm::robot {

/// Whether an arm comes nearer to itself or to an obstacle than it should, by exact distances of capsules and
/// rounded boxes (PlacedShapes says which of them). One thread: it keeps work space.
class CollisionWorld {
 public:
  /// `attached` are shapes fixed to the flange (link = jointCount()): camera bar, sling.
  CollisionWorld(const ArmDescription& arm, std::span<const Capsule> attached,
                 std::span<const Obstacle> obstacles, const SafeDistances& keep = {});
  ~CollisionWorld();
  CollisionWorld(CollisionWorld&&) noexcept;
  CollisionWorld& operator=(CollisionWorld&&) noexcept;

  [[nodiscard]] bool collides(const Joints& q) const { return contact(q).has_value(); }
  /// What comes too near what there; of several the first found.
  [[nodiscard]] std::optional<Contact> contact(const Joints& q) const;

  /// The first contact on the straight joint motion, its ends included. Steps are as long as the distances
  /// prove to be clear, so nothing is jumped; where shapes are so near that no joint could move by
  /// `finest_rad` without proof, steps are of that size. Source: conservative advancement, Mirtich 1996.
  [[nodiscard]] std::optional<Contact> firstContact(const Joints& from, const Joints& to,
                                                    double finest_rad) const;

  /// From now on what is nearer at `q` than it should be may be as near as it is there, if it is not nearer
  /// than `floor`: so a motion that begins or ends there is judged by what it adds. What touches stays
  /// refused.
  void admit(const Joints& q, const SafeDistances& floor = kTouching);
  /// Everything keeps its whole distance again.
  void admitNothing();

 private:
  struct Body;
  std::unique_ptr<Body> body_;
};

}  // namespace mirrorarm::robot
