#include "benchmarks/vision/stereo_camera.h"

#include <algorithm>

namespace mirrorarm::benchmarks::vision {

StereoCamera::StereoCamera(const camera::StereoRig& rig, const NoiseTable& noise)
    : rig_(rig), noise_(noise), left_(rig.left, kSpread_px), right_(rig.right, kSpread_px) {}

camera::StereoFrame StereoCamera::shoot(std::span<const StereoDisc> discs, double sigma,
                                        TrialRandom& random) {
  left_.clear();
  right_.clear();
  for (const StereoDisc& disc : discs) {
    left_.add(disc.patch_C(), kContrast);
    right_.add(simulation::transformed(rig_.X_RC, disc.patch_C()), kContrast);
  }
  camera::StereoFrame frame;
  frame.left = expose(left_, rig_.left, sigma, random);
  frame.right = expose(right_, rig_.right, sigma, random);
  return frame;
}

camera::GreyImage StereoCamera::expose(simulation::LightImage& light, const camera::CameraModel& camera,
                                       double sigma, TrialRandom& random) const {
  const int width = camera.intrinsics().width_px, height = camera.intrinsics().height_px;
  std::vector<std::uint8_t> pixels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  const float scale = static_cast<float>(sigma), ground = static_cast<float>(kGround) + 0.5F;
  for (int y = 0; y < height; ++y) {
    const float* const from = light.row(y);
    const float* const normal = noise_.row(width, random);
    std::uint8_t* const to = pixels.data() + static_cast<std::ptrdiff_t>(y) * width;
    for (int x = 0; x < width; ++x)
      to[x] = static_cast<std::uint8_t>(std::clamp(from[x] + ground + scale * normal[x], 0.0F, 255.0F));
  }
  return {width, height, std::move(pixels)};
}

}  // namespace mirrorarm::benchmarks::vision
