#include "benchmarks/vision/moving_scene.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "benchmarks/suite.h"
#include "benchmarks/vision/stereo_discs.h"
#include "core/simulation/stereo_renderer.h"

namespace mirrorarm::benchmarks::vision {
namespace {

constexpr double kRate_hz = 24.0, kExposure_s = 0.0015;

/// Ten discs on a half cylinder around x that looks along -z, no three in a row.
std::vector<simulation::Disc> halfCylinder() {
  constexpr int kDiscs = 10;
  constexpr double kRadius_m = 0.045;
  std::vector<simulation::Disc> discs;
  for (int i = 0; i < kDiscs; ++i) {
    const double angle = (-50.0 + 100.0 * ((i * 7) % kDiscs) / (kDiscs - 1)) * std::numbers::pi / 180.0;
    const double along = -0.06 + 0.12 * i / (kDiscs - 1);
    const Eigen::Vector3d normal(0.0, std::sin(angle), -std::cos(angle));
    discs.push_back({Eigen::Vector3d(along, 0.0, 0.0) + kRadius_m * normal, normal, 0.007});
  }
  return discs;
}

/// Target T in the left camera, swinging around 0.4 m before the middle between both.
RigidTransform poseAt(double time_s) {
  const double phase = 2.0 * std::numbers::pi * 0.64 * time_s;
  const Eigen::AngleAxisd turn(15.0 * std::numbers::pi / 180.0 * std::sin(0.7 * phase),
                               Eigen::Vector3d(0.3, 0.8, 0.5).normalized());
  const Eigen::Vector3d middle(0.06, 0.0, 0.44);
  return makeTransform(turn.toRotationMatrix(),
                       middle + 0.05 * Eigen::Vector3d(std::sin(phase), 0.6 * std::cos(phase), 0.0));
}

simulation::StereoRenderer::Instant targetAt(const std::vector<simulation::Disc>& discs_T, double time_s) {
  simulation::StereoRenderer::Instant instant;
  for (const auto& disc : discs_T)
    instant.push_back(simulation::transformed(poseAt(time_s), simulation::patchOf(disc)));
  return instant;
}

/// A glow that is no marker where a disc would have its place: a strip, a square or a speck.
simulation::Patch spuriousAt(const StereoDisc& place, int kind) {
  simulation::Patch patch = place.patch_C();
  const double lengths[] = {6.0, 2.0, 0.15}, widths[] = {0.5, 2.0, 0.15};
  patch.u *= lengths[kind];
  patch.v *= widths[kind];
  patch.outline = simulation::Patch::Outline::kRectangle;
  patch.retroreflective = false;
  patch.strength = 0.6;
  return patch;
}

}  // namespace

std::vector<MovingFrame> movingTarget(const camera::StereoRig& rig, int count) {
  const auto discs_T = halfCylinder();
  simulation::StereoRenderer renderer(rig, {}, {});
  std::vector<MovingFrame> frames;
  for (int i = 0; i < count; ++i) {
    const double time_s = i / kRate_hz;
    std::vector<simulation::StereoRenderer::Instant> instants_C;
    for (const double share : simulation::kInstants)
      instants_C.push_back(targetAt(discs_T, time_s + share * kExposure_s));
    MovingFrame made;
    std::tie(made.frame.left, made.frame.right) =
        renderer.render(instants_C, kSeed + static_cast<unsigned>(i));
    for (const auto& disc : discs_T) made.discs_C.push_back(poseAt(time_s) * disc.p_B);
    frames.push_back(std::move(made));
  }
  return frames;
}

std::vector<MovingFrame> crowdedScene(const camera::StereoRig& rig, int count) {
  constexpr int kDiscs = 80, kSpurious = 20;
  constexpr double kGap_px = 32.0;
  constexpr std::uint64_t kStream = 71;
  simulation::StereoRenderer renderer(rig, {}, {});
  std::vector<MovingFrame> frames;
  for (int i = 0; i < count; ++i) {
    TrialRandom random(kSeed, kStream, static_cast<std::uint64_t>(i));
    const auto places = randomDiscs(rig, kDiscs + kSpurious, {}, kGap_px, random);
    MovingFrame made;
    simulation::StereoRenderer::Instant instant;
    for (std::size_t k = 0; k < places.size(); ++k) {
      const bool disc = k < kDiscs;
      instant.push_back(disc ? places[k].patch_C() : spuriousAt(places[k], static_cast<int>(k % 3)));
      if (disc) made.discs_C.push_back(places[k].centre_C);
    }
    std::tie(made.frame.left, made.frame.right) =
        renderer.render({&instant, 1}, 2 * kSeed + static_cast<unsigned>(i));
    frames.push_back(std::move(made));
  }
  return frames;
}

}  // namespace mirrorarm::benchmarks::vision
