#include <gtest/gtest.h>

#include "core/experiments/occlusion.h"
#include "core/experiments/scene_trial.h"

using namespace mirrorarm;
using namespace mirrorarm::experiments;

namespace {

PlayedScene cuboid(double covered_share) {
  const std::filesystem::path resources = RESOURCES;
  auto scene = simulation::readScene(resources / "scenes" / "paper_cuboid.yaml", resources).value();
  scene.camera.grid->frames = 1;
  scene.frames = 48;
  scene.covered_share = covered_share;
  return play(scene, resources).value();
}

}  // namespace

TEST(SceneTrial, TheCuboidIsTaughtAndTrackedWithHalfTheMarkersCovered) {
  const auto whole = cuboid(0.0), covered = cuboid(0.5);
  ASSERT_EQ(whole.shots.size(), 48u);
  const auto target = teachFrom(whole, Approach{}.centres);
  ASSERT_TRUE(target);
  EXPECT_EQ(target->markers_T.size(), 10u);
  const auto seen = statisticsOf(track(whole, *target, {}, true));
  EXPECT_EQ(seen.trackedShare(), 1.0);
  EXPECT_LT(seen.fit_rms_mm, 0.06);
  EXPECT_LT(seen.rms_mm, 0.06);
  const auto half = statisticsOf(track(covered, *target, {}, true));
  EXPECT_EQ(half.trackedShare(), 1.0);
  EXPECT_LT(half.fit_rms_mm, 0.1);
  EXPECT_LT(half.rms_mm, 0.1);
}

TEST(SceneTrial, AMissingResourceIsNamed) {
  const auto rows = measureOcclusion("/nowhere");
  ASSERT_FALSE(rows);
  EXPECT_NE(rows.error().find("paper_cuboid.yaml"), std::string::npos);
}
