#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "core/calibration/board.h"
#include "core/camera/stereo_rig.h"
#include "core/simulation/stereo_renderer.h"

namespace mirrorarm::calibration {

/// What stands before a dot plate on the simulated bench.
struct PlateScene {
  std::vector<int> hidden;  ///< dots that something covers
  int lights = 0;           ///< beside and between the dots
  bool mirrored = false;    ///< a print of the pattern's mirror image
};

/// Renders dot plates through a rig with the sensors' noise, as a person holds them.
class PlateBench {
 public:
  PlateBench(const camera::StereoRig& rig, const Board& plate);

  /// A pose in which both cameras see most of the plate: at 0.25 to 0.65 m, up to `most_tilt_rad` from square
  /// to the line of sight, in any turn.
  [[nodiscard]] RigidTransform pose(double most_tilt_rad);

  /// So many dots, any of them.
  [[nodiscard]] std::vector<int> someDots(double share);

  [[nodiscard]] std::pair<camera::GreyImage, camera::GreyImage> images(const RigidTransform& X_CM,
                                                                       const PlateScene& scene = {});

  /// Where a camera (0, 1) shows the centre of the fitted outline of a dot.
  [[nodiscard]] Eigen::Vector2d truth(const RigidTransform& X_CM, int camera, int point) const;
  /// How many dots that camera shows, lit well.
  [[nodiscard]] int shown(const RigidTransform& X_CM, int camera) const;

  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }

 private:
  [[nodiscard]] simulation::Patch dot(int point, bool mirrored) const;
  [[nodiscard]] simulation::Patch light();
  [[nodiscard]] const camera::CameraModel& lens(int camera) const {
    return camera == 0 ? rig_.left : rig_.right;
  }
  [[nodiscard]] RigidTransform poseIn(int camera, const RigidTransform& X_CM) const {
    return camera == 0 ? X_CM : rig_.X_RC * X_CM;
  }

  camera::StereoRig rig_;
  Board plate_;
  std::vector<Eigen::Vector3d> points_;
  std::vector<double> diameters_m_;
  simulation::StereoRenderer renderer_;
  std::uint64_t seed_ = 0;
  std::mt19937 random_{11};
};

}  // namespace mirrorarm::calibration
