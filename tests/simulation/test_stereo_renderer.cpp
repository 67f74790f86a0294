#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

#include "core/camera/rig_file.h"
#include "core/simulation/stereo_renderer.h"

namespace mirrorarm::simulation {
namespace {

camera::StereoRig fisheye() {
  return *camera::readRig(std::filesystem::path(RESOURCES) / "rigs/fisheye.yaml");
}

Patch discAt(const Eigen::Vector3d& p, const Eigen::Vector3d& normal) { return patchOf({p, normal, 0.007}); }

/// Weighted centre of what is brighter than the ground, and the brightest value.
struct Spot {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  double width = 0.0;
  int brightest = 0;
};

Spot spotOf(const camera::GreyImage& image, double ground) {
  Spot spot;
  double mass = 0.0, spread = 0.0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const double value = image.view().at(x, y) - ground;
      spot.brightest = std::max(spot.brightest, static_cast<int>(image.view().at(x, y)));
      if (value < 20.0) continue;
      mass += value;
      spot.centre += value * Eigen::Vector2d(x, y);
      spread += value * x * x;
    }
  spot.centre /= mass;
  spot.width = std::sqrt(spread / mass - spot.centre.x() * spot.centre.x());
  return spot;
}

TEST(StereoRenderer, BothImagesShowTheDiscWhereTheRigProjectsIt) {
  const auto rig = fisheye();
  StereoRenderer renderer(rig, {}, {});
  const Eigen::Vector3d p(0.05, -0.03, 0.4);
  const StereoRenderer::Instant instant{discAt(p, {0.1, 0.2, -1.0})};
  const auto [left, right] = renderer.render(std::span(&instant, 1), 1);
  EXPECT_LT((spotOf(left, 9.0).centre - *rig.left.project(p)).norm(), 0.15);
  EXPECT_LT((spotOf(right, 9.0).centre - *rig.right.project(rig.X_RC * p)).norm(), 0.15);
  EXPECT_NEAR(spotOf(left, 9.0).brightest, 209, 14);  // levelled, and one camera is the brighter one
}

TEST(StereoRenderer, EqualSeedsGiveEqualImages) {
  const auto rig = fisheye();
  StereoRenderer renderer(rig, {}, {}), other(rig, {}, {});
  const StereoRenderer::Instant instant{discAt({0.0, 0.0, 0.4}, -Eigen::Vector3d::UnitZ())};
  const auto bytes = static_cast<std::size_t>(1296 * 964);
  const auto a = renderer.render(std::span(&instant, 1), 7), b = other.render(std::span(&instant, 1), 7);
  const auto c = other.render(std::span(&instant, 1), 8);
  EXPECT_EQ(std::memcmp(a.first.view().data, b.first.view().data, bytes), 0);
  EXPECT_NE(std::memcmp(a.first.view().data, c.first.view().data, bytes), 0);
  EXPECT_NE(std::memcmp(a.first.view().data, a.second.view().data, bytes), 0);
}

TEST(StereoRenderer, TheGroundHasTheSensorsNoise) {
  StereoRenderer renderer(fisheye(), {}, {});
  const auto [left, right] = renderer.render({}, 3);
  double sum = 0.0, squares = 0.0;
  const double count = 1296.0 * 964.0;
  for (int y = 0; y < 964; ++y)
    for (int x = 0; x < 1296; ++x) {
      sum += left.view().at(x, y);
      squares += left.view().at(x, y) * left.view().at(x, y);
    }
  const double mean = sum / count;
  EXPECT_NEAR(mean, 9.0, 0.05);
  EXPECT_NEAR(squares / count - mean * mean, 9.0 / 30.0 + 0.64 + 1.0 / 12.0, 0.05);
}

TEST(StereoRenderer, MovementBlursAlongItsWay) {
  const auto rig = fisheye();
  StereoRenderer renderer(rig, {}, {});
  std::vector<StereoRenderer::Instant> still, moved;
  for (const double share : kInstants) {
    still.push_back({discAt({0.0, 0.0, 0.4}, -Eigen::Vector3d::UnitZ())});
    moved.push_back({discAt({0.006 * share, 0.0, 0.4}, -Eigen::Vector3d::UnitZ())});
  }
  const auto sharp = spotOf(renderer.render(still, 1).first, 9.0);
  const auto blurred = spotOf(renderer.render(moved, 1).first, 9.0);
  const double way_px = 0.006 / 0.4 * 551.3;
  EXPECT_NEAR(blurred.width * blurred.width - sharp.width * sharp.width, way_px * way_px / 12.0, 0.6);
  EXPECT_LT((sharp.centre - blurred.centre).norm(), 0.05);
}

TEST(StereoRenderer, SlantedDiscsFadeAndVanish) {
  EXPECT_EQ(retroreflection(1.0), 1.0);
  EXPECT_EQ(retroreflection(std::cos(1.30)), 0.0);
  EXPECT_EQ(retroreflection(-1.0), 0.0);
  EXPECT_GT(retroreflection(std::cos(0.8)), retroreflection(std::cos(1.0)));
  const StereoRenderer renderer(fisheye(), {}, {});
  EXPECT_TRUE(renderer.bothSee(discAt({0.06, 0.0, 0.4}, -Eigen::Vector3d::UnitZ())));
  EXPECT_FALSE(renderer.bothSee(discAt({0.06, 0.0, 0.4}, Eigen::Vector3d::UnitX())));
  EXPECT_FALSE(renderer.bothSee(discAt({1.5, 0.0, 0.4}, -Eigen::Vector3d::UnitX())));
}

TEST(StereoRenderer, StrongLightSaturates) {
  LightSettings light;
  light.bright_level = 400.0;
  StereoRenderer renderer(fisheye(), light, {});
  const StereoRenderer::Instant instant{discAt({0.0, 0.0, 0.4}, -Eigen::Vector3d::UnitZ())};
  EXPECT_EQ(spotOf(renderer.render(std::span(&instant, 1), 1).first, 9.0).brightest, 255);
}

}  // namespace
}  // namespace mirrorarm::simulation
