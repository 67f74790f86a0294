#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/camera/stereo_rig.h"
#include "core/simulation/light_image.h"
#include "core/simulation/patch.h"
#include "core/simulation/sensor.h"

namespace mirrorarm::simulation {

struct LightSettings {
  double spread_sigma_px = 0.7;  ///< of the lens
  double bright_level = 200.0;  ///< the gain levels the brightest reflection to it; also a glow of strength 1
  double least_gain = 0.25;     ///< of the gain, against a disc at 0.4 m facing its camera
  double most_gain = 4.0;
};

/// Share of the ring light that marker film sends back, 0..1: full near normal incidence, nothing beyond
/// about 72 degrees. `cosine` is that of the entrance angle.
[[nodiscard]] double retroreflection(double cosine);

/// Makes image pairs of patches: light of a ring around each lens, inverse square of the distance,
/// entrance-angle fall-off, gain levelled per pair, then the sensors' noise. One thread; keeps its work
/// space.
class StereoRenderer {
 public:
  StereoRenderer(const camera::StereoRig& rig, const LightSettings& light, const SensorSettings& sensor);

  /// The patches at one instant of the exposure, in the left camera's frame.
  using Instant = std::vector<Patch>;
  /// Even shares of the exposure; each instant holds the same patches, so movement blurs them.
  [[nodiscard]] std::pair<camera::GreyImage, camera::GreyImage> render(std::span<const Instant> instants_C,
                                                                       std::uint64_t seed);

  /// True when both cameras see the middle of the patch, 10 pixels inside their images, lit well enough to be
  /// found.
  [[nodiscard]] bool bothSee(const Patch& patch_C) const;

 private:
  struct Side {
    RigidTransform X_SC;  ///< from the left camera's frame
    camera::CameraModel camera;
    LightImage light;
    Sensor sensor;
  };
  [[nodiscard]] double brightest(std::span<const Patch> patches_C) const;
  [[nodiscard]] camera::GreyImage expose(Side& side, std::span<const Instant> instants_C, double gain,
                                         std::uint64_t seed) const;

  LightSettings settings_;
  Side left_;
  Side right_;
};

/// Where in the exposure, in shares of it before and after its middle, three even instants lie that blur like
/// the whole: Chebyshev's rule, exact for movement with constant jerk.
inline constexpr double kInstants[] = {-0.35355339059327373, 0.0, 0.35355339059327373};

}  // namespace mirrorarm::simulation
