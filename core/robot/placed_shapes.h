#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/robot/arm_description.h"
#include "core/robot/capsule_distance.h"
#include "core/robot/contact.h"
#include "core/robot/obstacle.h"
#include "core/robot/safe_distances.h"

namespace mirrorarm::robot {

/// A shape, and the shape or the obstacle that it could meet.
struct ShapePair {
  int shape = -1;       ///< of the two the farther from the base
  int other = -1;       ///< a shape; -1 for an obstacle
  int obstacle = -1;    ///< an obstacle; -1 for a shape
  double keep_m = 0.0;  ///< nearer than this they must not come
};

/// How far the two of a pair are apart, in base frame.
struct Gap {
  double distance_m = 0.0;   ///< of their surfaces; negative where they overlap
  Eigen::Vector3d on_shape;  ///< the point of the shape's axis nearest to the other
  Eigen::Vector3d on_other;  ///< the nearest point of the other's axis, or of the obstacle's box
  Eigen::Vector3d away;      ///< unit vector along which the shape would leave the other
};

/// The shapes of one arm and the obstacles around it, where they are in one posture, and how near they are
/// to each other. Distances are exact. No call after construction allocates. One thread.
class PlacedShapes {
 public:
  /// Where a joint is and what it turns about, in base frame.
  struct JointAxis {
    Eigen::Vector3d axis = Eigen::Vector3d::UnitZ(), origin = Eigen::Vector3d::Zero();
  };

  /// Nothing at all.
  PlacedShapes() = default;
  /// `attached` are shapes fixed to the flange (link = jointCount()): camera bar, sling.
  PlacedShapes(const ArmDescription& arm, std::span<const Capsule> attached,
               std::span<const Obstacle> obstacles, const SafeDistances& keep);

  /// All that could meet. Shapes on the same link or on neighbouring links are left out: they always touch.
  /// So are the base and obstacles: neither moves. Those that the arm's build or its place holds nearer than
  /// they should be in every posture need not keep a distance, but must not touch.
  [[nodiscard]] const std::vector<ShapePair>& pairs() const noexcept { return pairs_; }

  void place(const Joints& q) noexcept;

  /// In the posture of the last call of place().
  [[nodiscard]] const JointAxis& axis(int joint) const noexcept {
    return axes_[static_cast<std::size_t>(joint)];
  }
  /// By the balls around both: no more than their distance, and fast.
  [[nodiscard]] double atLeast(const ShapePair& pair) const noexcept;
  [[nodiscard]] Gap gap(const ShapePair& pair) const noexcept;

  /// What the two are.
  [[nodiscard]] ContactKinds kinds(const ShapePair& pair) const noexcept;
  [[nodiscard]] const ArmDescription& arm() const noexcept { return arm_; }
  [[nodiscard]] const Capsule& capsule(int shape) const noexcept { return at(shape).capsule; }
  [[nodiscard]] int count() const noexcept { return static_cast<int>(shapes_.size()); }
  /// The axis of a shape in base frame.
  [[nodiscard]] const Segment& segment(int shape) const noexcept { return at(shape).segment; }
  [[nodiscard]] const Obstacle& obstacle(int obstacle) const noexcept {
    return barriers_[static_cast<std::size_t>(obstacle)].obstacle;
  }

 private:
  struct Shape {
    Capsule capsule;
    double reach_m = 0.0;  ///< of the ball around it
    Segment segment{};
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  };
  struct Barrier {
    Obstacle obstacle;
    RigidTransform X_OB;
  };

  [[nodiscard]] const Shape& at(int shape) const noexcept { return shapes_[static_cast<std::size_t>(shape)]; }
  void addPairsOf(int shape, const SafeDistances& keep);
  void spareWhatIsAlwaysNear();

  ArmDescription arm_;
  std::vector<Shape> shapes_;  // in the order of their links
  std::vector<Barrier> barriers_;
  std::vector<ShapePair> pairs_;
  std::array<JointAxis, kMaxJoints> axes_{};
};

}  // namespace mirrorarm::robot
