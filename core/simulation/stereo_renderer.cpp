#include "core/simulation/stereo_renderer.h"

#include <algorithm>
#include <cmath>

#include "core/simulation/counter_random.h"

namespace mirrorarm::simulation {
namespace {

constexpr double kReference_m = 0.4;
constexpr double kFoundShare = 0.12;

/// Light that comes back to the camera at the origin, against a disc at 0.4 m on the axis that faces it.
double returned(const Patch& patch_S) {
  if (!patch_S.retroreflective) return patch_S.strength;
  const double distance = patch_S.centre.norm();
  const Eigen::Vector3d towards = -patch_S.centre / distance;
  const double entrance = patch_S.u.cross(patch_S.v).normalized().dot(towards);
  const double nearness = kReference_m / distance;
  return patch_S.strength * retroreflection(entrance) * std::max(-towards.z(), 0.0) * nearness * nearness;
}

}  // namespace

double retroreflection(double cosine) {
  constexpr double kNothing = 0.309, kFull = 0.866;  // cosines of 72 and 30 degrees
  const double t = std::clamp((cosine - kNothing) / (kFull - kNothing), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

StereoRenderer::StereoRenderer(const camera::StereoRig& rig, const LightSettings& light,
                               const SensorSettings& sensor)
    : settings_(light),
      left_{RigidTransform::Identity(),
            rig.left,
            {rig.left, light.spread_sigma_px},
            {rig.left.intrinsics().width_px, rig.left.intrinsics().height_px, sensor}},
      right_{rig.X_RC,
             rig.right,
             {rig.right, light.spread_sigma_px},
             {rig.right.intrinsics().width_px, rig.right.intrinsics().height_px, sensor}} {}

double StereoRenderer::brightest(std::span<const Patch> patches_C) const {
  double most = 0.0;
  for (const Patch& patch_C : patches_C)
    if (patch_C.retroreflective)
      for (const Side* side : {&left_, &right_}) {
        const auto patch_S = transformed(side->X_SC, patch_C);
        const auto pixel = side->camera.project(patch_S.centre);
        if (pixel && side->camera.sees(*pixel)) most = std::max(most, returned(patch_S));
      }
  return most;
}

std::pair<camera::GreyImage, camera::GreyImage> StereoRenderer::render(std::span<const Instant> instants_C,
                                                                       std::uint64_t seed) {
  const double most = instants_C.empty() ? 0.0 : brightest(instants_C[instants_C.size() / 2]);
  const double gain = std::clamp(most > 0.0 ? 1.0 / most : 1.0, settings_.least_gain, settings_.most_gain);
  auto left = expose(left_, instants_C, gain, counterRandom(seed, 0));
  auto right = expose(right_, instants_C, gain, counterRandom(seed, 1));
  return {std::move(left), std::move(right)};
}

camera::GreyImage StereoRenderer::expose(Side& side, std::span<const Instant> instants_C, double gain,
                                         std::uint64_t seed) const {
  side.light.clear();
  const double share = 1.0 / static_cast<double>(std::max<std::size_t>(instants_C.size(), 1));
  for (const Instant& instant_C : instants_C)
    for (const Patch& patch_C : instant_C) {
      const auto patch_S = transformed(side.X_SC, patch_C);
      const double level =
          returned(patch_S) * (patch_C.retroreflective ? gain : 1.0) * settings_.bright_level;
      side.light.add(patch_S, level * share);
    }
  return side.sensor.expose(side.light, seed);
}

bool StereoRenderer::bothSee(const Patch& patch_C) const {
  constexpr double kMargin_px = 10.0;
  for (const Side* side : {&left_, &right_}) {
    const auto patch_S = transformed(side->X_SC, patch_C);
    const auto pixel = side->camera.project(patch_S.centre);
    if (!pixel || !side->camera.sees(*pixel, kMargin_px) || returned(patch_S) < kFoundShare) return false;
  }
  return true;
}

}  // namespace mirrorarm::simulation
