#include <algorithm>
#include <random>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "core/vision/epipolar_geometry.h"
#include "core/vision/stereo_matcher.h"
#include "core/vision/triangulation.h"
#include "stereo_bench.h"

namespace mirrorarm::vision {
namespace {

DetectedMarker markerAt(const Eigen::Vector2d& pixel, double sigma_px) {
  DetectedMarker marker;
  marker.centre_px = pixel;
  marker.covariance_px2 = sigma_px * sigma_px * Eigen::Matrix2d::Identity();
  return marker;
}

struct Pair {
  std::vector<DetectedMarker> left, right;
};

/// Both images of `points_C` with noise; the right ones in another order.
Pair imagesOf(const camera::StereoRig& rig, const std::vector<Eigen::Vector3d>& points_C, double sigma_px,
              std::mt19937& random) {
  std::normal_distribution<double> noise(0.0, sigma_px);
  Pair pair;
  for (const auto& p_C : points_C) {
    const Eigen::Vector2d left = *rig.left.project(p_C);
    const Eigen::Vector2d right = *rig.right.project(rig.X_RC * p_C);
    pair.left.push_back(markerAt(left + Eigen::Vector2d(noise(random), noise(random)), sigma_px));
    pair.right.push_back(markerAt(right + Eigen::Vector2d(noise(random), noise(random)), sigma_px));
  }
  std::reverse(pair.right.begin(), pair.right.end());
  return pair;
}

std::vector<Eigen::Vector3d> forearm(std::mt19937& random, int count) {
  std::uniform_real_distribution<double> even(-1.0, 1.0);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < count; ++i) {
    const double along = even(random), around = even(random);
    points.emplace_back(0.05 + 0.10 * along, 0.045 * std::sin(around), 0.42 - 0.045 * std::cos(around));
  }
  return points;
}

class EveryRig : public testing::TestWithParam<camera::LensModel> {
 protected:
  camera::StereoRig rig_ = benchRig(GetParam());
  std::mt19937 random_{21};
};

TEST_P(EveryRig, RectifiedRowsAgreeAndDisparityIsPositive) {
  const EpipolarGeometry geometry(rig_);
  for (const auto& p_C : forearm(random_, 20)) {
    const auto left = geometry.left(*rig_.left.project(p_C));
    const auto right = geometry.right(*rig_.right.project(rig_.X_RC * p_C));
    ASSERT_TRUE(left && right);
    EXPECT_NEAR(left->rectified_px.y(), right->rectified_px.y(), 1e-6);
    EXPECT_GT(left->rectified_px.x(), right->rectified_px.x());
    EXPECT_LT(geometry.epipolarDistance_px(*left, *right), 1e-6);
  }
}

TEST_P(EveryRig, TriangulationScattersAsItsCovarianceSays) {
  const Eigen::Vector3d p_C(0.06, 0.03, 0.41);
  double normalised = 0.0;
  const int trials = 500;
  for (int i = 0; i < trials; ++i) {
    const auto pair = imagesOf(rig_, {p_C}, 0.1, random_);
    const auto point = triangulate(rig_, pair.left[0], pair.right[0]);
    ASSERT_TRUE(point);
    const Eigen::Vector3d error = point->p_C - p_C;
    EXPECT_LT(error.norm(), 3e-3);
    normalised += error.dot(point->covariance_m2.inverse() * error);
  }
  EXPECT_NEAR(normalised / trials, 3.0, 0.35);
}

TEST_P(EveryRig, AllPairsOfAForearmAreRight) {
  int wrong = 0, missing = 0;
  for (int round = 0; round < 100; ++round) {
    const auto points = forearm(random_, 10);
    const auto pair = imagesOf(rig_, points, 0.05, random_);
    MatcherSettings settings;
    settings.epipolar_tolerance_px = 0.5;
    const auto matched = matchStereo(rig_, pair.left, pair.right, settings);
    missing += 10 - static_cast<int>(matched.size());
    for (const auto& point : matched) wrong += point.right == 9 - point.left ? 0 : 1;
  }
  EXPECT_LE(wrong, 10);
  EXPECT_LE(missing, 10);
}

INSTANTIATE_TEST_SUITE_P(StereoMatcher, EveryRig,
                         testing::Values(camera::LensModel::kBrownConrady,
                                         camera::LensModel::kKannalaBrandt));

class Matcher : public testing::Test {
 protected:
  camera::StereoRig rig_ = benchRig(camera::LensModel::kBrownConrady);
  std::mt19937 random_{22};
};

TEST_F(Matcher, DisparityGradientResolvesAnEpipolarClash) {
  // Two discs of one row among others at the same depth: crossed over, their pairs would lie far off the
  // surface.
  std::vector<Eigen::Vector3d> points{{0.02, 0.0, 0.40}, {0.05, 0.0, 0.40}};
  for (int i = 0; i < 6; ++i) points.emplace_back(0.01 * i, 0.03 + 0.008 * (i % 3), 0.40 + 0.002 * i);
  const auto pair = imagesOf(rig_, points, 0.02, random_);
  const auto matched = matchStereo(rig_, pair.left, pair.right, MatcherSettings{});
  ASSERT_EQ(matched.size(), points.size());
  for (const auto& point : matched) {
    EXPECT_EQ(point.right, static_cast<int>(points.size()) - 1 - point.left);
    EXPECT_LT((point.p_C - points[static_cast<std::size_t>(point.left)]).norm(), 1e-3);
    EXPECT_LT(point.epipolar_px, 0.2);
  }
}

TEST_F(Matcher, EveryMarkerIsUsedOnce) {
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 12; ++i) points.emplace_back(-0.05 + 0.012 * i, 0.0, 0.4 + 0.01 * (i % 4));
  const auto pair = imagesOf(rig_, points, 0.1, random_);
  const auto matched = matchStereo(rig_, pair.left, pair.right, MatcherSettings{});
  std::vector<int> lefts, rights;
  for (const auto& point : matched) {
    lefts.push_back(point.left);
    rights.push_back(point.right);
  }
  for (auto* used : {&lefts, &rights}) {
    std::sort(used->begin(), used->end());
    EXPECT_EQ(std::adjacent_find(used->begin(), used->end()), used->end());
  }
}

TEST_F(Matcher, RefusesDepthsOutsideItsRange) {
  const auto far = imagesOf(rig_, {{0.0, 0.0, 3.0}}, 0.0, random_);
  EXPECT_TRUE(matchStereo(rig_, far.left, far.right, MatcherSettings{}).empty());
  const auto near = imagesOf(rig_, {{0.06, 0.0, 0.3}}, 0.0, random_);
  MatcherSettings settings;
  settings.min_depth_m = 0.35;
  EXPECT_TRUE(matchStereo(rig_, near.left, near.right, settings).empty());
}

TEST_F(Matcher, ALoneDiscAndAnEmptyImageAreNoTrouble) {
  const auto pair = imagesOf(rig_, {{0.06, 0.0, 0.4}}, 0.0, random_);
  EXPECT_EQ(matchStereo(rig_, pair.left, pair.right, MatcherSettings{}).size(), 1U);
  EXPECT_TRUE(matchStereo(rig_, pair.left, {}, MatcherSettings{}).empty());
  EXPECT_TRUE(matchStereo(rig_, {}, {}, MatcherSettings{}).empty());
}

TEST_F(Matcher, MarkersWithoutARayAreLeftOut) {
  const auto nowhere = markerAt({std::nan(""), 5.0}, 0.1);
  const auto pair = imagesOf(rig_, {{0.06, 0.0, 0.4}}, 0.0, random_);
  EXPECT_TRUE(matchStereo(rig_, std::vector{nowhere}, pair.right, MatcherSettings{}).empty());
  EXPECT_FALSE(triangulate(rig_, nowhere, pair.right[0]));
  EXPECT_FALSE(triangulate(rig_, markerAt({100, 482}, 0.1), markerAt({1200, 482}, 0.1))) << "rays run apart";
}

}  // namespace
}  // namespace mirrorarm::vision
