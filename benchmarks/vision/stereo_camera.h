#pragma once

#include <span>

#include "benchmarks/vision/noise_table.h"
#include "benchmarks/vision/stereo_discs.h"
#include "core/camera/stereo_frame.h"
#include "core/simulation/light_image.h"

namespace mirrorarm::benchmarks::vision {

/// Both images of evenly bright discs through the lenses of a rig, exact, with white noise. One thread; keeps
/// its work space.
class StereoCamera {
 public:
  StereoCamera(const camera::StereoRig& rig, const NoiseTable& noise);

  static constexpr double kGround = 12.0, kContrast = 180.0, kSpread_px = 0.7;

  /// `sigma` grey values of noise; 0 only rounds to 8 bits.
  [[nodiscard]] camera::StereoFrame shoot(std::span<const StereoDisc> discs, double sigma,
                                          TrialRandom& random);

 private:
  camera::GreyImage expose(simulation::LightImage& light, const camera::CameraModel& camera, double sigma,
                           TrialRandom& random) const;

  camera::StereoRig rig_;
  const NoiseTable& noise_;
  simulation::LightImage left_;
  simulation::LightImage right_;
};

}  // namespace mirrorarm::benchmarks::vision
