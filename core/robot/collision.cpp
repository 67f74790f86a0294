#include "core/robot/collision.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/robot/capsule_distance.h"

namespace mirrorarm::robot {
namespace {

/// One capsule and where it is now.
struct Shape {
  Capsule capsule;
  double half_length_m = 0.0;
  Segment segment{};
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
};

struct Barrier {
  Obstacle obstacle;
  Eigen::Matrix3d R_OB;
};

/// A shape, and the shape or the obstacle that it may meet.
struct Pair {
  int shape = 0;
  int other = -1;
  int obstacle = -1;
  Joints reach_m;  ///< how far a point of the one goes, seen from the other, per radian of each joint
  double clear_until = 0.0;  ///< share of the motion at hand, up to which they cannot meet
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
  Body(const ArmDescription& described, std::span<const Capsule> attached,
       std::span<const Obstacle> obstacles)
      : arm(described) {
    for (const auto& source : {std::span<const Capsule>(arm.shapes), attached})
      for (const Capsule& capsule : source) shapes.push_back({capsule, 0.5 * (capsule.b - capsule.a).norm()});
    std::ranges::stable_sort(shapes, {}, [](const Shape& shape) { return shape.capsule.link; });
    for (const Obstacle& obstacle : obstacles)
      barriers.push_back({obstacle, obstacle.X_BO.linear().transpose()});
    for (int i = 0; i < static_cast<int>(shapes.size()); ++i) addPairsOf(i);
  }

  void addPairsOf(int i) {
    const Capsule& capsule = shapeAt(i).capsule;
    for (int j = 0; j < i; ++j)
      if (const int link = shapeAt(j).capsule.link; capsule.link - link > 1)
        pairs.push_back({i, j, -1, reachOf(arm, capsule, link)});
    if (capsule.link == 0) return;
    for (int k = 0; k < static_cast<int>(barriers.size()); ++k)
      pairs.push_back({i, -1, k, reachOf(arm, capsule, 0)});
  }

  [[nodiscard]] const Shape& shapeAt(int i) const { return shapes[static_cast<std::size_t>(i)]; }

  void place(const Joints& q) {
    RigidTransform X_BL = RigidTransform::Identity();
    int link = 0;
    for (Shape& shape : shapes) {  // in the order of their links
      for (; link < shape.capsule.link; ++link) {
        const JointDescription& joint = arm.joints[static_cast<std::size_t>(link)];
        X_BL = X_BL * joint.X_parent * Eigen::AngleAxisd(q[link], joint.axis);
      }
      shape.segment = {X_BL * shape.capsule.a, X_BL * shape.capsule.b};
      shape.middle = 0.5 * (shape.segment.a + shape.segment.b);
    }
  }

  /// No more than the distance of the pair; where the balls around both touch, the distance itself.
  [[nodiscard]] double distance(const Pair& pair) const {
    const Shape& shape = shapeAt(pair.shape);
    if (pair.obstacle >= 0) return distanceTo(barriers[static_cast<std::size_t>(pair.obstacle)], shape);
    const Shape& other = shapeAt(pair.other);
    const double radii = shape.capsule.radius_m + other.capsule.radius_m;
    const double balls =
        (shape.middle - other.middle).norm() - shape.half_length_m - other.half_length_m - radii;
    return balls > 0.0 ? balls : nearest(shape.segment, other.segment).distance_m - radii;
  }

  [[nodiscard]] static double distanceTo(const Barrier& barrier, const Shape& shape) {
    const Eigen::Vector3d half = 0.5 * barrier.obstacle.size_m, origin = barrier.obstacle.X_BO.translation();
    const double radii = shape.capsule.radius_m + barrier.obstacle.round_m;
    const Eigen::Vector3d middle = barrier.R_OB * (shape.middle - origin);
    const double ball = (middle.cwiseAbs() - half).cwiseMax(0.0).norm() - shape.half_length_m - radii;
    if (ball > 0.0) return ball;
    const Segment segment{barrier.R_OB * (shape.segment.a - origin),
                          barrier.R_OB * (shape.segment.b - origin)};
    return nearestToBox(segment, half).distance_m - radii;
  }

  [[nodiscard]] Contact contactOf(const Pair& pair) const {
    const ArmPart part = shapeAt(pair.shape).capsule.part;
    if (pair.obstacle >= 0) {
      const Obstacle& obstacle = barriers[static_cast<std::size_t>(pair.obstacle)].obstacle;
      return {part, obstacle.kind, obstacle.name};
    }
    return {std::max(part, shapeAt(pair.other).capsule.part), std::nullopt};
  }

  /// Marks each pair that might meet at `share` of the motion `way` with how far on it cannot.
  [[nodiscard]] std::optional<Contact> lookAhead(double share, const Joints& way) {
    for (Pair& pair : pairs) {
      if (pair.clear_until > share) continue;
      const double apart = distance(pair);
      if (apart <= 0.0) return contactOf(pair);
      const double nearing = pair.reach_m.dot(way);
      pair.clear_until = nearing > 0.0 ? share + apart / nearing : 2.0;
    }
    return std::nullopt;
  }

  ArmDescription arm;
  std::vector<Shape> shapes;
  std::vector<Barrier> barriers;
  std::vector<Pair> pairs;
};

CollisionWorld::CollisionWorld(const ArmDescription& arm, std::span<const Capsule> attached,
                               std::span<const Obstacle> obstacles)
    : body_(std::make_unique<Body>(arm, attached, obstacles)) {}
CollisionWorld::~CollisionWorld() = default;
CollisionWorld::CollisionWorld(CollisionWorld&&) noexcept = default;
CollisionWorld& CollisionWorld::operator=(CollisionWorld&&) noexcept = default;

std::optional<Contact> CollisionWorld::contact(const Joints& q) const {
  body_->place(q);
  for (const Pair& pair : body_->pairs)
    if (body_->distance(pair) <= 0.0) return body_->contactOf(pair);
  return std::nullopt;
}

std::optional<Contact> CollisionWorld::firstContact(const Joints& from, const Joints& to,
                                                    double finest_rad) const {
  const Joints way = (to - from).cwiseAbs();
  const double finest = finest_rad / std::max(way.maxCoeff(), finest_rad);
  for (Pair& pair : body_->pairs) pair.clear_until = 0.0;
  for (double share = 0.0;;) {
    body_->place(from + share * (to - from));
    if (auto contact = body_->lookAhead(share, way)) return contact;
    if (share >= 1.0) return std::nullopt;
    const auto first = std::ranges::min_element(body_->pairs, {}, &Pair::clear_until);
    const double proven = first == body_->pairs.end() ? 1.0 : first->clear_until;
    share = std::min(1.0, std::max(proven, share + finest));
  }
}

}  // namespace mirrorarm::robot
