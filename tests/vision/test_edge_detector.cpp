#include <set>

#include <gtest/gtest.h>

#include "core/vision/edge_detector.h"
#include "core/vision/outline.h"
#include "rendering.h"

namespace mirrorarm::vision {
namespace {

class Edges : public testing::Test {
 protected:
  std::vector<EdgePoint> detect(const Rendering& scene, const Region& region,
                                const EdgeThresholds& thresholds) {
    std::mt19937 random(1);
    image_ = scene.expose(0.0, random);
    const auto points = detector_.detect({image_.view(), 0}, region, thresholds);
    return {points.begin(), points.end()};
  }

  EdgeDetector detector_{1.0};
  camera::GreyImage image_;
};

TEST_F(Edges, OfAStraightStepLieOnItToTwoHundredthsOfAPixel) {
  Rendering scene(60, 60, 20);
  scene.strip({20.375, 30.0}, 20.0, 50.0, 0.0, 150);
  const auto points = detect(scene, {22, 22, 38, 38}, {15.0F, 6.0F});
  ASSERT_GE(points.size(), 10U);
  for (const auto& point : points) {
    EXPECT_NEAR(point.position_px.x(), 30.375, 0.02);
    EXPECT_LT(point.gradient.x(), 0.0F) << "the bright side is left";
    EXPECT_GT(point.sharpness, 0.0F);
  }
}

TEST_F(Edges, OfADiscFormOneClosedContour) {
  Rendering scene(60, 60, 20);
  scene.disc({30.2, 29.6}, 14.0, 150);
  const auto points = detect(scene, {14, 14, 46, 46}, {15.0F, 6.0F});
  std::set<int> contours;
  for (const auto& point : points) {
    contours.insert(point.contour);
    EXPECT_NEAR((point.position_px - Eigen::Vector2f(30.2F, 29.6F)).norm(), 6.85F, 0.12F);
  }
  EXPECT_EQ(contours.size(), 1U);
}

TEST_F(Edges, WeakOnesStayOnlyInAStrongContour) {
  Rendering scene(60, 60, 20);
  scene.disc({30, 30}, 14.0, 30);
  EXPECT_TRUE(detect(scene, {14, 14, 46, 46}, {40.0F, 2.0F}).empty());
  EXPECT_FALSE(detect(scene, {14, 14, 46, 46}, {8.0F, 2.0F}).empty());
}

TEST_F(Edges, OutlineIsTheContourAroundTheCandidate) {
  Rendering scene(80, 60, 20);
  scene.disc({30, 30}, 14.0, 150);
  scene.disc({48, 30}, 10.0, 200);
  const auto points = detect(scene, {14, 14, 66, 46}, {15.0F, 6.0F});
  std::vector<EdgePoint> outline;
  selectOutline(points, {30, 30}, 10.0F, outline);
  ASSERT_GE(outline.size(), 30U);
  for (const auto& point : outline) EXPECT_LT((point.position_px - Eigen::Vector2f(30, 30)).norm(), 8.0F);
}

TEST_F(Edges, TinyRegionsHaveNone) {
  const Rendering scene(8, 8, 20);
  EXPECT_TRUE(detect(scene, {3, 3, 3, 3}, {1.0F, 1.0F}).empty());
  EXPECT_TRUE(detect(scene, {0, 0, 7, 7}, {1.0F, 1.0F}).empty());
}

}  // namespace
}  // namespace mirrorarm::vision
