#include <algorithm>
#include <random>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "core/vision/epipolar_geometry.h"
#include "core/vision/stereo_matcher.h"
#include "core/vision/triangulation.h"
#include "disc_images.h"
#include "stereo_bench.h"
#include "tests/common/no_heap.h"

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

class EveryRig : public ::testing::TestWithParam<camera::LensModel> {
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
    EXPECT_LT(EpipolarGeometry::epipolarDistance_px(*left, *right), 1e-6);
    EXPECT_LT((geometry.pointOf(*left, *right) - p_C).norm(), 1e-8);
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

/// Those to take when no model decides.
std::vector<StereoPoint> preferred(std::span<const StereoPoint> points) {
  std::vector<StereoPoint> taken;
  std::copy_if(points.begin(), points.end(), std::back_inserter(taken),
               [](const StereoPoint& point) { return point.preferred; });
  return taken;
}

TEST_P(EveryRig, AllPreferredPairsOfAForearmAreRight) {
  int wrong = 0, missing = 0, lost = 0;
  StereoMatcher matcher(rig_, MatcherSettings{});
  for (int round = 0; round < 100; ++round) {
    const auto pair = imagesOf(rig_, forearm(random_, 10), 0.05, random_);
    const auto points = matcher.match(pair.left, pair.right);
    const auto is_right = [](const StereoPoint& point) { return point.right == 9 - point.left; };
    lost += 10 - static_cast<int>(std::count_if(points.begin(), points.end(), is_right));
    const auto taken = preferred(points);
    missing += 10 - static_cast<int>(taken.size());
    for (const auto& point : taken) wrong += is_right(point) ? 0 : 1;
  }
  EXPECT_EQ(lost, 0) << "true pairs are handed on, whatever their rivals";
  EXPECT_LE(wrong, 10);
  EXPECT_LE(missing, 20);
}

TEST_P(EveryRig, CorrectedDiscsScatterAsTheirCovarianceSays) {
  StereoMatcher matcher(rig_, MatcherSettings{});
  for (const double sigma_px : {0.005, 0.05}) {
    double normalised = 0.0;
    const int discs = 500;
    for (int i = 0; i < discs; ++i) {
      const auto disc = anyDisc(random_, 0.3 + 0.3 * i / discs);
      const auto left = markerOf(rig_.left, RigidTransform::Identity(), disc, sigma_px, random_);
      const auto right = markerOf(rig_.right, rig_.X_RC, disc, sigma_px, random_);
      const auto points = matcher.match({&left, 1}, {&right, 1});
      ASSERT_EQ(points.size(), 1U);
      const Eigen::Vector3d error = points[0].p_C - disc.p_C;
      normalised += error.dot(points[0].covariance_m2.inverse() * error);
      EXPECT_LT((points[0].left_px - *rig_.left.project(disc.p_C)).norm(), 5.0 * sigma_px + 0.002);
    }
    EXPECT_NEAR(normalised / discs, 3.0, 0.35) << sigma_px;
  }
}

TEST_P(EveryRig, UncorrectedDiscsAreOff) {
  const WorldDisc disc{{0.05, 0.04, 0.3}, tilted({0.0, 0.0, 1.0}, 0.7, 0.8)};
  const auto left = markerOf(rig_.left, RigidTransform::Identity(), disc, 1e-4, random_);
  const auto right = markerOf(rig_.right, rig_.X_RC, disc, 1e-4, random_);
  MatcherSettings settings;
  const auto corrected = StereoMatcher(rig_, settings).match({&left, 1}, {&right, 1})[0];
  settings.correct_centres = false;
  const auto raw = StereoMatcher(rig_, settings).match({&left, 1}, {&right, 1})[0];
  EXPECT_GT((raw.p_C - disc.p_C).norm(), 5.0 * (corrected.p_C - disc.p_C).norm());
  EXPECT_EQ(raw.left_px, left.centre_px);
  EXPECT_GT(raw.normal_C.dot(disc.normal_C), 0.999);
  EXPECT_NEAR(raw.radius_m, disc.radius_m, 1e-5);
}

INSTANTIATE_TEST_SUITE_P(StereoMatcher, EveryRig,
                         ::testing::Values(camera::LensModel::kBrownConrady,
                                           camera::LensModel::kKannalaBrandt));

class Matcher : public ::testing::Test {
 protected:
  std::vector<StereoPoint> match(std::span<const DetectedMarker> left,
                                 std::span<const DetectedMarker> right) {
    StereoMatcher matcher(rig_, settings_);
    const auto points = matcher.match(left, right);
    return {points.begin(), points.end()};
  }
  std::vector<StereoPoint> match(const Pair& pair) { return match(pair.left, pair.right); }

  camera::StereoRig rig_ = benchRig(camera::LensModel::kBrownConrady);
  MatcherSettings settings_;
  std::mt19937 random_{22};
};

TEST_F(Matcher, DisparityGradientResolvesAnEpipolarClash) {
  // Two discs of one row among others at the same depth: crossed over, their pairs would lie far off the
  // surface.
  std::vector<Eigen::Vector3d> points{{0.02, 0.0, 0.40}, {0.05, 0.0, 0.40}};
  for (int i = 0; i < 6; ++i) points.emplace_back(0.01 * i, 0.03 + 0.008 * (i % 3), 0.40 + 0.002 * i);
  const auto taken = preferred(match(imagesOf(rig_, points, 0.02, random_)));
  ASSERT_EQ(taken.size(), points.size());
  for (const auto& point : taken) {
    EXPECT_EQ(point.right, static_cast<int>(points.size()) - 1 - point.left);
    EXPECT_LT((point.p_C - points[static_cast<std::size_t>(point.left)]).norm(), 1e-3);
    EXPECT_LT(point.epipolar_px, 0.2);
  }
}

std::vector<Eigen::Vector3d> row(int count) {
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < count; ++i) points.emplace_back(-0.05 + 0.012 * i, 0.0, 0.4 + 0.01 * (i % 4));
  return points;
}

TEST_F(Matcher, ARepeatedRowGivesRivalsAndLosesNoTruePair) {
  const auto points = match(imagesOf(rig_, row(12), 0.05, random_));
  int right = 0;
  for (const auto& point : points) {
    const auto rivals = std::count_if(points.begin(), points.end(), [&](const StereoPoint& other) {
      return (other.left == point.left) != (other.right == point.right);
    });
    EXPECT_EQ(point.rivals, rivals);
    right += point.right == 11 - point.left ? 1 : 0;
  }
  EXPECT_EQ(right, 12);
  EXPECT_GT(points.size(), 20U);
}

TEST_F(Matcher, PreferredPairsShareNoDisc) {
  const auto points = match(imagesOf(rig_, row(12), 0.1, random_));
  const auto taken = preferred(points);
  std::vector<int> lefts, rights;
  for (const auto& point : taken) {
    lefts.push_back(point.left);
    rights.push_back(point.right);
  }
  for (auto* used : {&lefts, &rights}) {
    std::sort(used->begin(), used->end());
    EXPECT_EQ(std::adjacent_find(used->begin(), used->end()), used->end());
  }
  EXPECT_GE(taken.size(), 6U);
}

TEST_F(Matcher, OrderOfTheMarkersDoesNotMatter) {
  auto pair = imagesOf(rig_, row(12), 0.1, random_);
  auto before = match(pair);
  std::vector<int> order(12);
  for (int i = 0; i < 12; ++i) order[static_cast<std::size_t>(i)] = i;
  std::shuffle(order.begin(), order.end(), random_);
  Pair shuffled;
  for (const int i : order) {
    shuffled.left.push_back(pair.left[static_cast<std::size_t>(i)]);
    shuffled.right.push_back(pair.right[static_cast<std::size_t>(11 - i)]);
  }
  auto after = match(shuffled);
  ASSERT_EQ(after.size(), before.size());
  const auto by_place = [](const StereoPoint& a, const StereoPoint& b) { return a.p_C.z() < b.p_C.z(); };
  std::sort(before.begin(), before.end(), by_place);
  std::sort(after.begin(), after.end(), by_place);
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_EQ(after[i].p_C, before[i].p_C);
    EXPECT_EQ(after[i].preferred, before[i].preferred);
    EXPECT_EQ(after[i].rivals, before[i].rivals);
    EXPECT_NEAR(after[i].support, before[i].support, 1e-9);
  }
}

TEST_F(Matcher, TheGateFollowsTheCovariance) {
  auto pair = imagesOf(rig_, {{0.06, 0.0, 0.4}}, 0.0, random_);
  pair.right[0].centre_px.y() += 3.0;
  EXPECT_TRUE(match(pair).empty());
  pair.right[0].covariance_px2.setIdentity();
  EXPECT_EQ(match(pair).size(), 1U) << "so uncertain a centre may be that far off";
  pair.right[0].covariance_px2 << 9.0, 0.0, 0.0, 0.01;
  EXPECT_TRUE(match(pair).empty()) << "uncertain along the line only";
}

TEST_F(Matcher, TheGateFollowsTheCalibration) {
  auto pair = imagesOf(rig_, {{0.06, 0.0, 0.4}}, 0.01, random_);
  pair.right[0].centre_px.y() += 1.0;
  EXPECT_EQ(match(pair).size(), 1U) << "a rig without a record may be that far off";
  rig_.calibration.hold_out_epipolar_px = 0.1;
  EXPECT_TRUE(match(pair).empty());
  rig_.calibration.hold_out_epipolar_px = 0.5;
  EXPECT_EQ(match(pair).size(), 1U);
}

TEST_F(Matcher, TruePairsOfPoorImagesPassTheGates) {
  const double sigma_px = 0.06;  // at a signal ten times the noise
  int kept = 0;
  const int discs = 500;
  for (int i = 0; i < discs; ++i) {
    const auto disc = anyDisc(random_, 0.3 + 0.5 * i / discs);
    const auto left = markerOf(rig_.left, RigidTransform::Identity(), disc, sigma_px, random_);
    const auto right = markerOf(rig_.right, rig_.X_RC, disc, sigma_px, random_);
    kept += static_cast<int>(match({&left, 1}, {&right, 1}).size());
  }
  EXPECT_EQ(kept, discs);
}

TEST_F(Matcher, OutlinesThatNoDiscHasAreRefusedUnlessCut) {
  WorldDisc disc{{0.06, 0.01, 0.4}};
  const auto left = markerOf(rig_.left, RigidTransform::Identity(), disc, 0.02, random_);
  disc.radius_m = 0.0055;
  auto right = markerOf(rig_.right, rig_.X_RC, disc, 0.02, random_);
  EXPECT_TRUE(match({&left, 1}, {&right, 1}).empty());
  right.cut = true;
  EXPECT_EQ(match({&left, 1}, {&right, 1}).size(), 1U);
}

TEST_F(Matcher, RefusesDepthsOutsideItsRange) {
  EXPECT_TRUE(match(imagesOf(rig_, {{0.0, 0.0, 3.0}}, 0.0, random_)).empty());
  settings_.min_depth_m = 0.35;
  EXPECT_TRUE(match(imagesOf(rig_, {{0.06, 0.0, 0.3}}, 0.0, random_)).empty());
}

TEST_F(Matcher, ALoneDiscAndAnEmptyImageAreNoTrouble) {
  const auto pair = imagesOf(rig_, {{0.06, 0.0, 0.4}}, 0.0, random_);
  const auto points = match(pair);
  ASSERT_EQ(points.size(), 1U);
  EXPECT_TRUE(points[0].preferred);
  EXPECT_EQ(points[0].rivals, 0);
  EXPECT_TRUE(match(pair.left, {}).empty());
  EXPECT_TRUE(match({}, {}).empty());
}

TEST_F(Matcher, MarkersWithoutARayOrWithoutNumbersAreLeftOut) {
  const auto nowhere = markerAt({std::nan(""), 5.0}, 0.1);
  auto pair = imagesOf(rig_, {{0.06, 0.0, 0.4}}, 0.0, random_);
  EXPECT_TRUE(match(std::vector{nowhere}, pair.right).empty());
  EXPECT_FALSE(triangulate(rig_, nowhere, pair.right[0]));
  EXPECT_FALSE(triangulate(rig_, markerAt({100, 482}, 0.1), markerAt({1200, 482}, 0.1))) << "rays run apart";
  pair.left[0].covariance_px2(0, 1) = std::nan("");
  EXPECT_TRUE(match(pair).empty());
}

TEST_F(Matcher, SurvivesRigsThatAreNone) {
  const auto pair = imagesOf(rig_, row(5), 0.0, random_);
  rig_.X_RC.translation().setZero();
  EXPECT_TRUE(match(pair).empty());
  rig_.X_RC.translation().setConstant(std::nan(""));
  EXPECT_TRUE(match(pair).empty());
}

TEST_F(Matcher, AGridFullOfRivalsIsBounded) {
  std::vector<Eigen::Vector3d> grid;
  for (int y = 0; y < 12; ++y)
    for (int x = 0; x < 16; ++x) grid.emplace_back(-0.05 + 0.012 * x, -0.06 + 0.01 * y, 0.4);
  const auto points = match(imagesOf(rig_, grid, 0.02, random_));
  EXPECT_LE(points.size(), StereoMatcher::kMostPairs);
  EXPECT_GE(preferred(points).size(), 100U);
}

TEST_F(Matcher, TakesNothingFromTheHeapOnceWarm) {
  StereoMatcher matcher(rig_, settings_);
  const auto pair = imagesOf(rig_, row(12), 0.1, random_);
  static_cast<void>(matcher.match(pair.left, pair.right));
  EXPECT_EQ(mirrorarm::testing::heapCallsIn([&] { static_cast<void>(matcher.match(pair.left, pair.right)); }),
            0U);
}

}  // namespace
}  // namespace mirrorarm::vision
