#include "core/robot/obstacle.h"

namespace mirrorarm::robot {

std::string_view id(ObstacleKind kind) {
  switch (kind) {
    case ObstacleKind::kBox:
      return "box";
    case ObstacleKind::kTable:
      return "table";
    case ObstacleKind::kHead:
      return "head";
  }
  return "unknown";
}

Obstacle ball(ObstacleKind kind, const Eigen::Vector3d& centre_B, double radius_m) {
  return {
      makeTransform(Eigen::Quaterniond::Identity(), centre_B), Eigen::Vector3d::Zero(), kind, {}, radius_m};
}

}  // namespace mirrorarm::robot
