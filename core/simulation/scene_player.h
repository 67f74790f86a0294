#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/camera/stereo_frame.h"
#include "core/camera/stereo_rig.h"
#include "core/simulation/scene.h"
#include "core/simulation/target_carrier.h"

namespace mirrorarm::simulation {

/// Plays a scene frame by frame. The frames come in order; every one is a function of the scene alone. One
/// thread.
class ScenePlayer {
 public:
  /// Refused: files the scene names that cannot be read, poses that a robot does not reach.
  [[nodiscard]] static FromFile<ScenePlayer> make(const Scene& scene, const std::filesystem::path& resources);
  ~ScenePlayer();
  ScenePlayer(ScenePlayer&&) noexcept;
  ScenePlayer& operator=(ScenePlayer&&) noexcept;

  [[nodiscard]] const camera::StereoRig& rig() const;
  /// The target's markers in T.
  [[nodiscard]] const std::vector<Disc>& discs_T() const;

  struct Shot {
    camera::StereoFrame frame;
    RigidTransform X_CT = RigidTransform::Identity();  ///< at the middle of the exposure
    int visible = 0;                                   ///< uncovered markers that both cameras see
    std::optional<RobotPose> robot;  ///< the one that carries the cameras, else the one that holds the target
  };
  /// Frame `i` of 0..frames-1.
  [[nodiscard]] Shot shoot(int i);

 private:
  struct Body;
  explicit ScenePlayer(std::unique_ptr<Body> body);
  std::unique_ptr<Body> body_;
};

}  // namespace mirrorarm::simulation
