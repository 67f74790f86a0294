#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "benchmarks/vision/moving_scene.h"
#include "benchmarks/vision/reference_chain.h"
#include "benchmarks/vision/spurious_scene.h"
#include "benchmarks/vision/stereo_camera.h"

namespace mirrorarm::benchmarks::vision {
namespace {

double tilt_deg(const Eigen::Vector3d& eye, const StereoDisc& disc) {
  return std::acos((eye - disc.centre_C).normalized().dot(disc.normal_C)) * 180.0 / std::numbers::pi;
}

TEST(Scenes, StereoDiscsAreWhereTheyShouldBe) {
  const auto rig = fisheyeRig();
  const Eigen::Vector3d right_eye = rig.X_RC.inverse().translation();
  TrialRandom random(1, 2, 3);
  const auto discs = randomDiscs(rig, 30, {0.3, 0.6}, 40.0, random);
  ASSERT_EQ(discs.size(), 30U);
  for (const auto& disc : discs) {
    EXPECT_GE(disc.centre_C.norm(), 0.3);
    EXPECT_LE(disc.centre_C.norm(), 0.6);
    EXPECT_LE(tilt_deg(Eigen::Vector3d::Zero(), disc), 60.0 + 1e-9);
    EXPECT_LE(tilt_deg(right_eye, disc), 60.0 + 1e-9);
    EXPECT_LT((*rig.right.project(rig.X_RC * disc.centre_C) - disc.right_px).norm(), 1e-9);
    EXPECT_EQ(std::ranges::count_if(
                  discs, [&](const auto& other) { return (other.left_px - disc.left_px).norm() < 40.0; }),
              1);
  }
}

TEST(Scenes, StereoCameraShowsTheDiscs) {
  const auto rig = fisheyeRig();
  const NoiseTable noise;
  TrialRandom random(1, 2, 4);
  const auto discs = randomDiscs(rig, 5, {0.3, 0.5}, 40.0, random);
  const auto frame = StereoCamera(rig, noise).shoot(discs, 1.8, random);
  for (const auto& disc : discs) {
    EXPECT_GT(frame.left.view().at(static_cast<int>(std::round(disc.left_px.x())),
                                   static_cast<int>(std::round(disc.left_px.y()))),
              120);
    EXPECT_GT(frame.right.view().at(static_cast<int>(std::round(disc.right_px.x())),
                                    static_cast<int>(std::round(disc.right_px.y()))),
              120);
  }
}

TEST(Scenes, SpuriousFramesComeAgain) {
  const SpuriousScene scene(true);
  const auto first = scene.frame(5), again = scene.frame(5), other = scene.frame(6);
  ASSERT_EQ(first.lights.size(), again.lights.size());
  EXPECT_TRUE(
      std::equal(first.image.view().data, first.image.view().data + 640 * 480, again.image.view().data));
  EXPECT_FALSE(
      std::equal(first.image.view().data, first.image.view().data + 640 * 480, other.image.view().data));
}

TEST(Scenes, SpuriousLightsStandApart) {
  const SpuriousScene scene(true);
  for (std::uint64_t index = 0; index < 20; ++index) {
    const auto frame = scene.frame(index);
    EXPECT_EQ(std::ranges::count(frame.lights, Shape::kDisc, &PlacedLight::shape), SpuriousScene::kDiscs);
    EXPECT_GE(frame.lights.size(), 28U);
    for (const auto& light : frame.lights) {
      EXPECT_GE(light.contrast / frame.noise, 20.0 - 1e-9);
      EXPECT_LE(light.contrast / frame.noise, 100.0 + 1e-9);
      EXPECT_EQ(std::ranges::count_if(frame.lights,
                                      [&](const auto& other) {
                                        return (other.centre_px - light.centre_px).norm() <
                                               other.radius_px + light.radius_px;
                                      }),
                1)
          << "each touches itself alone";
    }
  }
}

TEST(Scenes, ReferenceChainFindsTheTarget) {
  const auto rig = fisheyeRig();
  ReferenceChain chain(rig);
  for (const auto& each : movingTarget(rig, 2)) {
    EXPECT_EQ(each.discs_C.size(), 10U);
    EXPECT_EQ(chain.run(each.frame), 20);
  }
}

}  // namespace
}  // namespace mirrorarm::benchmarks::vision
