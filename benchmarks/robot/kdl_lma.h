#pragma once

#include <memory>
#include <optional>

#include "core/robot/arm_description.h"
#include "core/robot/joints.h"

namespace mirrorarm::benchmarks::robot {

/// Inverse kinematics of KDL by Levenberg and Marquardt's steps, with its own settings. It knows no joint
/// ranges.
class KdlLma {
 public:
  explicit KdlLma(const mirrorarm::robot::ArmDescription& arm);
  ~KdlLma();
  /// Angles are brought within half a turn of zero.
  [[nodiscard]] std::optional<mirrorarm::robot::Joints> solve(const RigidTransform& X_BF,
                                                              const mirrorarm::robot::Joints& seed);

 private:
  struct Body;
  std::unique_ptr<Body> body_;
};

}  // namespace mirrorarm::benchmarks::robot
