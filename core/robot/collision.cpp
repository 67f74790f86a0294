#include "core/robot/collision.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/robot/placed_shapes.h"

namespace mirrorarm::robot {
namespace {

constexpr double kHair_m = 1e-6;  // what is admitted may be nearer by rounding

/// A pair, and what is known of it on the motion at hand.
struct WatchedPair {
  ShapePair pair;
  Joints reach_m;       ///< how far a point of the one goes, seen from the other, per radian of each joint
  double keep_m = 0.0;  ///< at present
  double clear_until = 0.0;  ///< share of the motion, up to which they cannot come too near
};

/// Farthest that a point of the shape can be from each joint's axis, for the joints between two links.
Joints reachOf(const ArmDescription& arm, const Capsule& capsule, int from_link) {
  Joints reach = Joints::Zero(arm.jointCount());
  double length = std::max(capsule.a.norm(), capsule.b.norm());
  for (int joint = capsule.link - 1; joint >= from_link; --joint) {
    reach[joint] = length;
    length += arm.joints[static_cast<std::size_t>(joint)].X_parent.translation().norm();
  }
  return reach;
}

}  // namespace

struct CollisionWorld::Body {
  Body(const ArmDescription& arm, std::span<const Capsule> attached, std::span<const Obstacle> obstacles,
       const SafeDistances& keep)
      : shapes(arm, attached, obstacles, keep) {
    for (const ShapePair& pair : shapes.pairs()) {
      const int from_link = pair.other >= 0 ? shapes.capsule(pair.other).link : 0;
      pairs.push_back({pair, reachOf(arm, shapes.capsule(pair.shape), from_link), pair.keep_m});
    }
  }

  /// How much nearer they may come, at least; zero and less where they are too near.
  [[nodiscard]] double room(const WatchedPair& watched) const {
    const double quickly = shapes.atLeast(watched.pair) - watched.keep_m;
    return quickly > 0.0 ? quickly : shapes.gap(watched.pair).distance_m - watched.keep_m;
  }

  [[nodiscard]] Contact contactOf(const ShapePair& pair) const {
    const auto [part, kind] = shapes.kinds(pair);
    return {part, kind, kind ? shapes.obstacle(pair.obstacle).name : std::string()};
  }

  /// Marks each pair that might meet at `share` of the motion `way` with how far on it cannot.
  [[nodiscard]] std::optional<Contact> lookAhead(double share, const Joints& way) {
    for (WatchedPair& watched : pairs) {
      if (watched.clear_until > share) continue;
      const double apart = room(watched);
      if (apart <= 0.0) return contactOf(watched.pair);
      const double nearing = watched.reach_m.dot(way);
      watched.clear_until = nearing > 0.0 ? share + apart / nearing : 2.0;
    }
    return std::nullopt;
  }

  PlacedShapes shapes;
  std::vector<WatchedPair> pairs;
};

CollisionWorld::CollisionWorld(const ArmDescription& arm, std::span<const Capsule> attached,
                               std::span<const Obstacle> obstacles, const SafeDistances& keep)
    : body_(std::make_unique<Body>(arm, attached, obstacles, keep)) {}
CollisionWorld::~CollisionWorld() = default;
CollisionWorld::CollisionWorld(CollisionWorld&&) noexcept = default;
CollisionWorld& CollisionWorld::operator=(CollisionWorld&&) noexcept = default;

std::optional<Contact> CollisionWorld::contact(const Joints& q) const {
  body_->shapes.place(q);
  for (const WatchedPair& watched : body_->pairs)
    if (body_->room(watched) <= 0.0) return body_->contactOf(watched.pair);
  return std::nullopt;
}

std::optional<Contact> CollisionWorld::firstContact(const Joints& from, const Joints& to,
                                                    double finest_rad) const {
  const Joints way = (to - from).cwiseAbs();
  const double finest = finest_rad / std::max(way.maxCoeff(), finest_rad);
  for (WatchedPair& watched : body_->pairs) watched.clear_until = 0.0;
  for (double share = 0.0;;) {
    body_->shapes.place(from + share * (to - from));
    if (auto contact = body_->lookAhead(share, way)) return contact;
    if (share >= 1.0) return std::nullopt;
    const auto first = std::ranges::min_element(body_->pairs, {}, &WatchedPair::clear_until);
    const double proven = first == body_->pairs.end() ? 1.0 : first->clear_until;
    share = std::min(1.0, std::max(proven, share + finest));
  }
}

void CollisionWorld::admit(const Joints& q, const SafeDistances& floor) {
  body_->shapes.place(q);
  for (WatchedPair& watched : body_->pairs) {
    if (body_->room(watched) > 0.0) continue;
    const double least = watched.pair.other >= 0 ? floor.self_m : floor.obstacle_m;
    const double there = body_->shapes.gap(watched.pair).distance_m - kHair_m;
    watched.keep_m = std::min(watched.keep_m, std::max(there, least));
  }
}

void CollisionWorld::admitNothing() {
  for (WatchedPair& watched : body_->pairs) watched.keep_m = watched.pair.keep_m;
}

}  // namespace mirrorarm::robot
