#include "core/robot/collision.h"

#include <algorithm>
#include <cstdlib>
#include <vector>

#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/collision_object.h>

#include "core/robot/kinematics.h"

namespace mirrorarm::robot {
namespace {

/// One shape and where it sits on its link.
struct Part {
  int link = 0;
  RigidTransform X_link_shape = RigidTransform::Identity();
  fcl::CollisionObjectd object;
  ArmPart part = ArmPart::kLink;
};

/// One obstacle and how it is called.
struct Barrier {
  fcl::CollisionObjectd object;
  Contact contact;
};

Part partOf(const Capsule& capsule) {
  const Eigen::Vector3d axis = capsule.b - capsule.a;
  const Eigen::Quaterniond along = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), axis);
  const Eigen::Vector3d middle = 0.5 * (capsule.a + capsule.b);
  if (axis.norm() < 1e-9)
    return {capsule.link, makeTransform(Eigen::Quaterniond::Identity(), middle),
            fcl::CollisionObjectd(std::make_shared<fcl::Sphered>(capsule.radius_m)), capsule.part};
  return {capsule.link, makeTransform(along, middle),
          fcl::CollisionObjectd(std::make_shared<fcl::Capsuled>(capsule.radius_m, axis.norm())),
          capsule.part};
}

bool touch(const fcl::CollisionObjectd& one, const fcl::CollisionObjectd& other) {
  if (!one.getAABB().overlap(other.getAABB())) return false;
  const fcl::CollisionRequestd request;
  fcl::CollisionResultd result;
  return fcl::collide(&one, &other, request, result) > 0;
}

}  // namespace

struct CollisionWorld::Body {
  Body(const ArmDescription& arm, std::span<const Capsule> attached, std::span<const Obstacle> all)
      : kinematics(arm) {
    for (const Capsule& shape : arm.shapes) parts.push_back(partOf(shape));
    for (const Capsule& shape : attached) parts.push_back(partOf(shape));
    for (const Obstacle& obstacle : all)
      barriers.push_back({objectOf(obstacle), {ArmPart::kLink, obstacle.kind, obstacle.name}});
  }

  /// A box with round edges is taken for the box around it.
  static fcl::CollisionObjectd objectOf(const Obstacle& obstacle) {
    if (obstacle.size_m.isZero()) return {std::make_shared<fcl::Sphered>(obstacle.round_m), obstacle.X_BO};
    const Eigen::Vector3d size = obstacle.size_m.array() + 2.0 * obstacle.round_m;
    return {std::make_shared<fcl::Boxd>(size), obstacle.X_BO};
  }

  void place(const Joints& q) {
    for (Part& part : parts) {
      part.object.setTransform(kinematics.link(q, part.link) * part.X_link_shape);
      part.object.computeAABB();
    }
  }

  [[nodiscard]] std::optional<Contact> withObstacle() const {
    for (const Part& part : parts)
      for (const Barrier& barrier : barriers)
        if (part.link > 0 && touch(part.object, barrier.object)) {
          Contact contact = barrier.contact;
          contact.part = part.part;
          return contact;
        }
    return std::nullopt;
  }

  [[nodiscard]] std::optional<Contact> withItself() const {
    for (std::size_t i = 0; i < parts.size(); ++i)
      for (std::size_t j = i + 1; j < parts.size(); ++j)
        if (std::abs(parts[i].link - parts[j].link) > 1 && touch(parts[i].object, parts[j].object))
          return Contact{std::max(parts[i].part, parts[j].part), std::nullopt};
    return std::nullopt;
  }

  Kinematics kinematics;
  std::vector<Part> parts;
  std::vector<Barrier> barriers;
};

CollisionWorld::CollisionWorld(const ArmDescription& arm, std::span<const Capsule> attached,
                               std::span<const Obstacle> obstacles)
    : body_(std::make_unique<Body>(arm, attached, obstacles)) {}
CollisionWorld::~CollisionWorld() = default;
CollisionWorld::CollisionWorld(CollisionWorld&&) noexcept = default;
CollisionWorld& CollisionWorld::operator=(CollisionWorld&&) noexcept = default;

std::optional<Contact> CollisionWorld::contact(const Joints& q) const {
  body_->place(q);
  if (auto contact = body_->withItself()) return contact;
  return body_->withObstacle();
}

}  // namespace mirrorarm::robot
