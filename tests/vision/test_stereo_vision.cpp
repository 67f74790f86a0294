#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "core/simulation/light_image.h"
#include "core/vision/stereo_vision.h"
#include "stereo_bench.h"
#include "tests/common/no_heap.h"

namespace mirrorarm::vision {
namespace {

constexpr double kDiscRadius_m = 0.0035;

/// One camera's image of discs that face the left camera, exactly through its lens, in white noise.
camera::GreyImage imageOf(const camera::CameraModel& camera, const RigidTransform& X_KC,
                          std::span<const Eigen::Vector3d> points_C, std::mt19937& random) {
  simulation::LightImage light(camera, 0.7);
  for (const auto& p_C : points_C) {
    simulation::Patch patch;
    patch.centre = p_C;
    patch.u = kDiscRadius_m * Eigen::Vector3d::UnitX();
    patch.v = -kDiscRadius_m * Eigen::Vector3d::UnitY();
    light.add(simulation::transformed(X_KC, patch), 170.0);
  }
  std::normal_distribution<float> noise(0.0F, 1.8F);
  const auto& size = camera.intrinsics();
  std::vector<std::uint8_t> pixels;
  for (int y = 0; y < size.height_px; ++y)
    for (int x = 0; x < size.width_px; ++x)
      pixels.push_back(static_cast<std::uint8_t>(
          std::clamp(std::round(12.0F + light.row(y)[x] + noise(random)), 0.0F, 255.0F)));
  return {size.width_px, size.height_px, std::move(pixels)};
}

class StereoVisionTest : public ::testing::Test {
 protected:
  camera::StereoFrame shoot(std::uint64_t sequence) {
    return {imageOf(rig_.left, RigidTransform::Identity(), points_C_, random_),
            imageOf(rig_.right, rig_.X_RC, points_C_, random_), fromNanoseconds(5), Seconds(0.0015),
            sequence};
  }

  camera::StereoRig rig_ = benchRig(camera::LensModel::kKannalaBrandt);
  std::vector<Eigen::Vector3d> points_C_{{0.00, 0.01, 0.40},  {0.03, -0.03, 0.41}, {0.05, 0.02, 0.39},
                                         {0.08, -0.01, 0.42}, {0.11, 0.03, 0.40},  {0.13, -0.04, 0.43}};
  std::mt19937 random_{31};
  StereoVision vision_{rig_, FinderSettings{}, MatcherSettings{}};
};

TEST_F(StereoVisionTest, RenderedDiscsComeBackWithinTheirSigma) {
  double normalised = 0.0;
  for (std::uint64_t sequence = 0; sequence < 3; ++sequence) {
    const auto observation = vision_.observe(shoot(sequence));
    EXPECT_EQ(observation.sequence, sequence);
    EXPECT_EQ(observation.exposed_at, fromNanoseconds(5));
    ASSERT_EQ(observation.points.size(), points_C_.size());
    for (const auto& point : observation.points) {
      const auto nearest = std::min_element(
          points_C_.begin(), points_C_.end(),
          [&](const auto& a, const auto& b) { return (a - point.p_C).norm() < (b - point.p_C).norm(); });
      const Eigen::Vector3d error = point.p_C - *nearest;
      EXPECT_LT(error.head<2>().norm(), 1e-4);
      EXPECT_LT(std::abs(error.z()), 3e-4);
      normalised += error.dot(point.covariance_m2.inverse() * error);
    }
  }
  EXPECT_LT(normalised / (3.0 * static_cast<double>(points_C_.size())), 6.0)
      << "3 when the covariance is right";
}

TEST_F(StereoVisionTest, ExpectedDiscsAloneAreLookedFor) {
  const auto frame = shoot(0);
  vision_.expect(std::span(points_C_).first(2), 0.006);
  EXPECT_EQ(vision_.observe(frame).points.size(), 2U);
  vision_.expect({}, 0.006);
  EXPECT_EQ(vision_.observe(frame).points.size(), points_C_.size());
}

TEST_F(StereoVisionTest, ExpectationOutOfViewLooksEverywhere) {
  const std::vector<Eigen::Vector3d> behind{{0.0, 0.0, -1.0}};
  vision_.expect(behind, 0.006);
  EXPECT_EQ(vision_.observe(shoot(0)).points.size(), points_C_.size());
}

TEST_F(StereoVisionTest, ImagesOfAnotherSizeGiveNoMarkers) {
  camera::StereoFrame frame{
      camera::GreyImage(4, 3, std::vector<std::uint8_t>(12, 200)), camera::GreyImage(), {}, {}, 9};
  const auto observation = vision_.observe(frame);
  EXPECT_EQ(observation.sequence, 9U);
  EXPECT_TRUE(observation.left.markers.empty());
  EXPECT_TRUE(observation.points.empty());
}

TEST_F(StereoVisionTest, MarkersCarryTheCentresOfTheirPreferredPair) {
  const auto observation = vision_.observe(shoot(0));
  ASSERT_EQ(observation.points.size(), points_C_.size());
  for (const auto& point : observation.points) {
    ASSERT_TRUE(point.preferred);
    const auto& left = observation.left.markers[static_cast<std::size_t>(point.left)];
    const auto& right = observation.right.markers[static_cast<std::size_t>(point.right)];
    EXPECT_EQ(left.centre_px, point.left_px);
    EXPECT_EQ(right.centre_px, point.right_px);
    EXPECT_NE(left.centre_px, left.ellipse.centre_px) << "corrected";
    EXPECT_LT((left.centre_px - left.ellipse.centre_px).norm(), 0.1);
  }
}

TEST_F(StereoVisionTest, ThePapersMethodUndistortsItselfAndIsNotCorrected) {
  FinderSettings settings;
  settings.method = CentreMethod::kLindebergFitzgibbon;
  StereoVision vision(rig_, settings, MatcherSettings{});
  for (const auto& marker : vision.observe(shoot(0)).left.markers)
    EXPECT_EQ(marker.centre_px, marker.ellipse.centre_px);
}

TEST_F(StereoVisionTest, TakesNothingFromTheHeapOnceWarm) {
  if (!mirrorarm::testing::heapIsCounted) GTEST_SKIP() << "a sanitizer brings its own heap";
  const auto frame = shoot(0);
  for (int i = 0; i < 3; ++i) static_cast<void>(vision_.observe(frame));
  EXPECT_EQ(mirrorarm::testing::heapCallsOfAllThreadsIn([&] { static_cast<void>(vision_.observe(frame)); }),
            0U);
}

TEST_F(StereoVisionTest, ManyFramesGiveWhatOneGives) {
  const auto frame = shoot(0);
  const auto first = vision_.observe(frame).points;
  for (int i = 0; i < 200; ++i) {
    const auto& points = vision_.observe(frame).points;
    ASSERT_EQ(points.size(), first.size());
    for (std::size_t k = 0; k < first.size(); ++k) ASSERT_EQ(points[k].p_C, first[k].p_C);
  }
}

TEST_F(StereoVisionTest, RigsThatAreNoneGiveNoMarkers) {
  const auto frame = shoot(3);
  auto scaled = rig_, still = rig_, nowhere = rig_, blind = rig_, bent = rig_;
  scaled.X_RC.linear() *= 1.1;
  still.X_RC.translation().setZero();
  nowhere.X_RC.translation().x() = std::nan("");
  auto lens = rig_.right.intrinsics();
  lens.fx_px = std::numeric_limits<double>::infinity();
  blind.right = camera::CameraModel(lens);
  lens = rig_.right.intrinsics();
  lens.distortion[1] = std::nan("");
  bent.right = camera::CameraModel(lens);
  for (const auto& rig : {scaled, still, nowhere, blind, bent}) {
    StereoVision vision(rig, FinderSettings{}, MatcherSettings{});
    vision.expect(points_C_, 0.006);
    const auto& observation = vision.observe(frame);
    EXPECT_EQ(observation.sequence, 3U);
    EXPECT_TRUE(observation.left.markers.empty());
    EXPECT_TRUE(observation.points.empty());
  }
}

TEST_F(StereoVisionTest, StartsAndStopsWithoutAFrame) {
  for (int i = 0; i < 20; ++i) StereoVision idle(rig_, FinderSettings{}, MatcherSettings{});
}

}  // namespace
}  // namespace mirrorarm::vision
