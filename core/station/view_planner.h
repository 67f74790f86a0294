#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/calibration/board.h"
#include "core/robot/arm_description.h"
#include "core/robot/collision.h"
#include "core/robot/kinematics.h"
#include "core/robot/motion_limits.h"
#include "core/robot/planner.h"

namespace mirrorarm::station {

/// What the arm must keep off while a board stands at X_BM: the board with a hand's breadth of air, and a
/// post from it down to the table, whose top lies at `table_height_m` over the base.
[[nodiscard]] std::vector<robot::Obstacle> boardObstacles(const calibration::Board& board,
                                                          const RigidTransform& X_BM, double table_height_m);

/// Where a board stands in the base and the camera on the flange, as far as both are known.
struct BoardPlace {
  calibration::Board board;
  RigidTransform X_BM = RigidTransform::Identity();
  RigidTransform X_FC = RigidTransform::Identity();
};

/// An arm and how it may move.
struct PlannedArm {
  robot::ArmDescription arm;
  std::vector<robot::Capsule> attached;
  std::vector<robot::Obstacle> obstacles;  ///< that stand there always
  robot::MotionLimits limits;
  robot::PlannerSettings planner;
  double table_height_m = 0.0;
};

/// Joints that bring the cameras before a board as wished, and clear paths there. One thread.
class ViewPlanner {
 public:
  ViewPlanner(const PlannedArm& arm, const BoardPlace& place);

  /// Joints that lead there from one of `seeds`, within the limits and clear of everything: of several those
  /// nearest to the last seed.
  [[nodiscard]] std::optional<robot::Joints> joints(const RigidTransform& X_CM,
                                                    std::span<const robot::Joints> seeds) const;
  /// Way points after `from`, `to` the last; nothing where no path is clear.
  [[nodiscard]] std::optional<std::vector<robot::Joints>> path(const robot::Joints& from,
                                                               const robot::Joints& to);
  /// The pose of the board in the camera when the flange is at `X_BF`.
  [[nodiscard]] RigidTransform viewFrom(const RigidTransform& X_BF) const;
  [[nodiscard]] RigidTransform flange(const robot::Joints& q) const { return kinematics_.flange(q); }

 private:
  [[nodiscard]] bool isWithinLimits(const robot::Joints& q) const;
  RigidTransform X_BM_;
  RigidTransform X_FC_;
  robot::MotionLimits limits_;
  robot::Kinematics kinematics_;
  robot::Planner planner_;
};

}  // namespace mirrorarm::station
