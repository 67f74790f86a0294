#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include "core/robot/joints.h"
#include "core/simulation/arm_motion.h"
#include "core/simulation/scene.h"

namespace mirrorarm::simulation {

/// A second robot that holds a target plate and shifts it along a path, as in the paper's latency experiment
/// (section 3.2). The joints are the truth: where the target is comes from them. It rests where the path
/// ends.
class HeldMotion final : public ArmMotion {
 public:
  /// Shift of the target in base B at a phase [m]; zero at 0.
  using Path = std::function<Eigen::Vector3d(double phase_s)>;

  /// The UR5 and the plate of a scene whose world is base B. Refused: another scene, a UR5 that does not
  /// reach all of the path.
  [[nodiscard]] static FromFile<std::unique_ptr<HeldMotion>> make(const Scene& scene,
                                                                  const std::filesystem::path& resources,
                                                                  const Path& path, double duration_s);

  [[nodiscard]] int discCount() const override { return static_cast<int>(discs_T_.size()); }
  void discsAt(double phase_s, std::span<Disc> discs) const override;
  /// From the UR5's flange to the plate.
  [[nodiscard]] Forearm forearmAt(double phase_s) const override;
  [[nodiscard]] RigidTransform poseAt(double phase_s) const;

 private:
  HeldMotion(std::vector<Disc> discs_T, const RigidTransform& X_TF, std::vector<RigidTransform> poses)
      : discs_T_(std::move(discs_T)), X_TF_(X_TF), poses_(std::move(poses)) {}

  std::vector<Disc> discs_T_;
  RigidTransform X_TF_;                ///< UR5's flange on the target
  std::vector<RigidTransform> poses_;  ///< X_BT, a step apart
};

}  // namespace mirrorarm::simulation
