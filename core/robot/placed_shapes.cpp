#include "core/robot/placed_shapes.h"

#include <algorithm>
#include <random>

namespace mirrorarm::robot {
namespace {

constexpr int kPostures = 100;  // by which it is judged what is always near

Joints randomPosture(const ArmDescription& arm, std::minstd_rand& random) {
  Joints q(arm.jointCount());
  for (int i = 0; i < arm.jointCount(); ++i) {
    const auto& joint = arm.joints[static_cast<std::size_t>(i)];
    q[i] = std::uniform_real_distribution<double>(joint.lower_rad, joint.upper_rad)(random);
  }
  return q;
}

/// Axes with `radii_m` of flesh around them.
Gap gapOf(const Nearest& axes, double radii_m) {
  const double sign = axes.distance_m < 0.0 ? -1.0 : 1.0;  // an axis goes through the box
  return {axes.distance_m - radii_m, axes.on_first, axes.on_second,
          sign * (axes.on_first - axes.on_second).normalized()};
}

}  // namespace

PlacedShapes::PlacedShapes(const ArmDescription& arm, std::span<const Capsule> attached,
                           std::span<const Obstacle> obstacles, const SafeDistances& keep)
    : arm_(arm) {
  for (const auto& source : {std::span<const Capsule>(arm.shapes), attached})
    for (const Capsule& capsule : source)
      shapes_.push_back({capsule, 0.5 * (capsule.b - capsule.a).norm() + capsule.radius_m});
  std::ranges::stable_sort(shapes_, {}, [](const Shape& shape) { return shape.capsule.link; });
  for (const Obstacle& obstacle : obstacles) barriers_.push_back({obstacle, obstacle.X_BO.inverse()});
  for (int shape = 0; shape < static_cast<int>(shapes_.size()); ++shape) addPairsOf(shape, keep);
  spareWhatIsAlwaysNear();
}

void PlacedShapes::addPairsOf(int shape, const SafeDistances& keep) {
  const int link = capsule(shape).link;
  for (int other = 0; other < shape; ++other)
    if (link - capsule(other).link > 1) pairs_.push_back({shape, other, -1, keep.self_m});
  if (link == 0) return;
  for (int k = 0; k < static_cast<int>(barriers_.size()); ++k)
    pairs_.push_back({shape, -1, k, keep.obstacle_m});
}

void PlacedShapes::spareWhatIsAlwaysNear() {
  std::minstd_rand random(1);
  std::vector<bool> always(pairs_.size(), true);
  for (int posture = 0; posture < kPostures; ++posture) {
    place(randomPosture(arm_, random));
    for (std::size_t i = 0; i < pairs_.size(); ++i)
      always[i] = always[i] && gap(pairs_[i]).distance_m < pairs_[i].keep_m;
  }
  for (std::size_t i = 0; i < pairs_.size(); ++i)
    if (always[i]) pairs_[i].keep_m = 0.0;
}

void PlacedShapes::place(const Joints& q) noexcept {
  RigidTransform X_BL = RigidTransform::Identity();
  int link = 0;
  for (Shape& shape : shapes_) {
    for (; link < shape.capsule.link; ++link) {
      const JointDescription& joint = arm_.joints[static_cast<std::size_t>(link)];
      X_BL = X_BL * joint.X_parent;
      axes_[static_cast<std::size_t>(link)] = {X_BL.linear() * joint.axis, X_BL.translation()};
      X_BL.linear() = X_BL.linear() * Eigen::AngleAxisd(q[link], joint.axis).toRotationMatrix();
    }
    shape.segment = {X_BL * shape.capsule.a, X_BL * shape.capsule.b};
    shape.middle = 0.5 * (shape.segment.a + shape.segment.b);
  }
}

ContactKinds PlacedShapes::kinds(const ShapePair& pair) const noexcept {
  const ArmPart part = capsule(pair.shape).part;
  if (pair.other >= 0) return {std::max(part, capsule(pair.other).part), std::nullopt};
  return {part, obstacle(pair.obstacle).kind};
}

double PlacedShapes::atLeast(const ShapePair& pair) const noexcept {
  const Shape& shape = at(pair.shape);
  if (pair.other >= 0) {
    const Shape& other = at(pair.other);
    return (shape.middle - other.middle).norm() - shape.reach_m - other.reach_m;
  }
  const Barrier& barrier = barriers_[static_cast<std::size_t>(pair.obstacle)];
  const Eigen::Vector3d beyond =
      ((barrier.X_OB * shape.middle).cwiseAbs() - 0.5 * barrier.obstacle.size_m).cwiseMax(0.0);
  return beyond.norm() - barrier.obstacle.round_m - shape.reach_m;
}

Gap PlacedShapes::gap(const ShapePair& pair) const noexcept {
  const Shape& shape = at(pair.shape);
  if (pair.other >= 0) {
    const Shape& other = at(pair.other);
    return gapOf(nearest(shape.segment, other.segment), shape.capsule.radius_m + other.capsule.radius_m);
  }
  const auto& [obstacle, X_OB] = barriers_[static_cast<std::size_t>(pair.obstacle)];
  Nearest found = nearestToBox({X_OB * shape.segment.a, X_OB * shape.segment.b}, 0.5 * obstacle.size_m);
  found.on_first = obstacle.X_BO * found.on_first;
  found.on_second = obstacle.X_BO * found.on_second;
  return gapOf(found, shape.capsule.radius_m + obstacle.round_m);
}

}  // namespace mirrorarm::robot
