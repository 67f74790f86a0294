#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/geometry/rigid_transform.h"

namespace mirrorarm::robot {

/// What an obstacle is to the people around the robot.
enum class ObstacleKind : std::uint8_t { kBox, kTable, kHead };
/// "box", "table", "head"
[[nodiscard]] std::string_view id(ObstacleKind kind);

/// Something the arm must not enter, in base frame B: all points within `round_m` of a box. A box without
/// size is a ball.
struct Obstacle {
  RigidTransform X_BO = RigidTransform::Identity();  ///< the box's middle and its axes
  Eigen::Vector3d size_m = Eigen::Vector3d::Ones();  ///< its sides along the axes of O, none negative
  ObstacleKind kind = ObstacleKind::kBox;
  std::string name = {};  ///< as the operator calls it
  double round_m = 0.0;
};

/// A head-like zone around `centre_B`.
[[nodiscard]] Obstacle ball(ObstacleKind kind, const Eigen::Vector3d& centre_B, double radius_m);

}  // namespace mirrorarm::robot
