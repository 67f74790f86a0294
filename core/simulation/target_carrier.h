#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/robot/joints.h"
#include "core/simulation/recorded_motion.h"
#include "core/simulation/scene.h"

namespace mirrorarm::simulation {

/// A robot as robot.csv records it.
struct RobotPose {
  robot::Joints q_rad;
  RigidTransform X_BF = RigidTransform::Identity();
};

/// Moves the target of a scene: lays it on a table, straps it to a forearm or lets a UR5 hold it. One thread.
class TargetCarrier {
 public:
  virtual ~TargetCarrier() = default;

  /// The target's markers in T, its frame at the start.
  [[nodiscard]] virtual const std::vector<Disc>& discs_T() const = 0;
  struct Moment {
    std::vector<Disc> discs_W;
    RigidTransform X_WT = RigidTransform::Identity();  ///< best rigid fit where the skin deforms
    std::optional<RobotPose> robot;                    ///< the UR5, in its own base
  };
  [[nodiscard]] virtual Moment at(double time_s) = 0;

  /// Refused: files of the scene that cannot be read, a UR5 that does not reach the start or a way point.
  [[nodiscard]] static FromFile<std::unique_ptr<TargetCarrier>> make(
      const Scene& scene, const RecordedMotion::CameraPositions& cameras_W,
      const std::filesystem::path& resources);
};

}  // namespace mirrorarm::simulation
