#include <cmath>
#include <numeric>
#include <random>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "core/vision/marker_finder.h"
#include "rendering.h"

namespace mirrorarm::vision {
namespace {

/// Errors of many discs, each at another place between pixels, slant and turn.
struct Errors {
  double rms_px = 0.0;  ///< an axis
  Eigen::Vector2d mean_px = Eigen::Vector2d::Zero();
  double normalised = 0.0;   ///< mean squared error by the covariance; 2 when it is right
  double diameter_px = 0.0;  ///< mean
  int found = 0;
  int others = 0;
};

Errors measure(double diameter_px, double snr, int trials, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> even(0.0, 1.0);
  MarkerFinder finder{FinderSettings{}};
  Errors errors;
  for (int i = 0; i < trials; ++i) {
    const Eigen::Vector2d centre(40 + even(random), 40 + even(random));
    const Eigen::Matrix2d axes = 0.5 * diameter_px *
                                 Eigen::Rotation2Dd(std::numbers::pi * even(random)).toRotationMatrix() *
                                 Eigen::Vector2d(1.0, 0.7 + 0.3 * even(random)).asDiagonal();
    Rendering scene(80, 80, 12);
    scene.disc(centre, axes, 180);
    const auto image = scene.expose(180 / snr, random);
    for (const auto& marker : finder.find(image.view()).markers) {
      const Eigen::Vector2d error = marker.centre_px - centre;
      if (error.norm() > 1.0) {
        ++errors.others;
        continue;
      }
      ++errors.found;
      errors.rms_px += 0.5 * error.squaredNorm();
      errors.mean_px += error;
      errors.normalised += error.dot(marker.covariance_px2.inverse() * error);
      errors.diameter_px += 2.0 * marker.ellipse.semi_major_px;
    }
  }
  const double n = std::max(errors.found, 1);
  errors.rms_px = std::sqrt(errors.rms_px / n);
  errors.mean_px /= n;
  errors.normalised /= n;
  errors.diameter_px /= n;
  return errors;
}

class EverySize : public testing::TestWithParam<double> {};

TEST_P(EverySize, CentresAreFoundWithoutBias) {
  const auto errors = measure(GetParam(), 100, 40, 5);
  EXPECT_EQ(errors.found, 40);
  EXPECT_EQ(errors.others, 0);
  EXPECT_LT(errors.rms_px, 0.015);
  EXPECT_LT(errors.mean_px.norm(), 0.006);
  EXPECT_NEAR(errors.diameter_px, GetParam(), 0.25);
}

TEST_P(EverySize, CovarianceIsHonestInNoise) {
  const auto errors = measure(GetParam(), 20, 40, 6);
  EXPECT_EQ(errors.found, 40);
  EXPECT_EQ(errors.others, 0);
  EXPECT_GT(errors.normalised, 0.3);
  EXPECT_LT(errors.normalised, 4.0);
}

INSTANTIATE_TEST_SUITE_P(MarkerFinder, EverySize, testing::Values(5.0, 6.0, 7.0, 10.0, 16.0, 24.0));

TEST(MarkerFinder, TenPixelDiscsAreCentredToAHundredthOfAPixel) {
  const auto errors = measure(10.0, 100, 100, 7);
  EXPECT_EQ(errors.found, 100);
  EXPECT_LT(errors.rms_px, 0.012);
}

/// A scene with discs and what is none.
struct Clutter {
  Rendering scene{640, 480, 14};
  std::vector<Eigen::Vector2d> discs;

  explicit Clutter(std::mt19937& random) {
    std::uniform_real_distribution<double> even(0.0, 1.0);
    for (int i = 0; i < 12; ++i) {
      discs.emplace_back(60 + 45 * i + 5 * even(random), 80 + 25 * (i % 3) + 5 * even(random));
      scene.disc(discs.back(), 6 + 12 * even(random), 60 + 120 * even(random));
    }
    scene.disc({120, 300}, 90.0, 150);
    scene.strip({300, 330}, 120, 6, 0.5, 160);
    scene.strip({420, 300}, 40, 9, -1.0, 160);
    scene.strip({560, 320}, 30, 30, 0.3, 120);
    scene.disc({2, 240}, 14.0, 150);
    for (int i = 0; i < 20; ++i) scene.speck(30 + 29 * i, 430, 200);
  }
};

TEST(MarkerFinder, FindsAllDiscsAndNothingElseInClutter) {
  std::mt19937 random(8);
  MarkerFinder finder{FinderSettings{}};
  for (int round = 0; round < 5; ++round) {
    const Clutter clutter(random);
    const auto image = clutter.scene.expose(2.0, random);
    const auto found = finder.find(image.view());
    EXPECT_EQ(found.markers.size(), clutter.discs.size());
    for (const auto& disc : clutter.discs) {
      const auto at = std::find_if(found.markers.begin(), found.markers.end(), [&](const auto& marker) {
        return (marker.centre_px - disc).norm() < 0.2;
      });
      EXPECT_NE(at, found.markers.end()) << disc.transpose();
    }
    EXPECT_GE(found.rejected[static_cast<std::size_t>(Rejection::kTooSmall)], 15);
    EXPECT_GE(found.rejected[static_cast<std::size_t>(Rejection::kTooLarge)], 1);
    EXPECT_GE(found.rejected[static_cast<std::size_t>(Rejection::kAtBorder)], 1);
  }
}

TEST(MarkerFinder, SeparatesDiscsWhoseBlurTouches) {
  Rendering scene(120, 80, 10);
  scene.disc({40, 40}, 10.0, 180);
  scene.disc({52.4, 40}, 10.0, 180);
  std::mt19937 random(9);
  const auto image = scene.expose(1.0, random);
  EXPECT_EQ(MarkerFinder{FinderSettings{}}.find(image.view()).markers.size(), 2U);
}

TEST(MarkerFinder, FindsDiscsOnALitSurface) {
  Rendering scene(200, 160, 10);
  scene.disc({100, 80}, 110.0, 50);
  scene.disc({80, 70}, 10.0, 150);
  scene.disc({120, 95}, 12.0, 150);
  std::mt19937 random(10);
  const auto image = scene.expose(1.0, random);
  EXPECT_EQ(MarkerFinder{FinderSettings{}}.find(image.view()).markers.size(), 2U);
}

TEST(MarkerFinder, DarkDotsAreTheNegativeOfBrightOnes) {
  std::mt19937 random(11);
  Rendering bright(100, 100, 40), dark(100, 100, 215);
  bright.disc({50.3, 49.8}, 12.0, 150);
  dark.disc({50.3, 49.8}, 12.0, -150);
  FinderSettings settings;
  const auto from_bright = MarkerFinder(settings).find(bright.expose(0.0, random).view());
  settings.dark_on_bright = true;
  const auto from_dark = MarkerFinder(settings).find(dark.expose(0.0, random).view());
  ASSERT_EQ(from_bright.markers.size(), 1U);
  ASSERT_EQ(from_dark.markers.size(), 1U);
  EXPECT_LT((from_bright.markers[0].centre_px - from_dark.markers[0].centre_px).norm(), 1e-3);
}

TEST(MarkerFinder, FitsUndistortedPointsAndAnswersInRawPixels) {
  // A fisheye bends the outline of a large disc near the border; truth is the disc's image through the lens.
  const camera::CameraModel lens(
      {camera::LensModel::kKannalaBrandt, 640, 480, 280, 280, 320, 240, {-0.02, 0.003, 0, 0, 0}});
  const Eigen::Vector3d p_C(0.32, 0.02, 0.25);
  const auto truth = lens.project(p_C);
  ASSERT_TRUE(truth);
  camera::CameraModel::ProjectJacobian J;
  ASSERT_TRUE(lens.project(p_C, J));
  const Eigen::Vector3d normal = -p_C.normalized();
  const Eigen::Vector3d u = normal.unitOrthogonal();
  Eigen::Matrix<double, 3, 2> plane;
  plane << u, normal.cross(u);
  Rendering scene(640, 480, 10);
  scene.disc(*truth, 0.014 * J * plane, 180);
  std::mt19937 random(12);
  const auto image = scene.expose(0.5, random);
  const auto found = MarkerFinder(FinderSettings{}, lens).find(image.view());
  ASSERT_EQ(found.markers.size(), 1U);
  EXPECT_LT((found.markers[0].centre_px - *truth).norm(), 0.05);
  EXPECT_LT((found.markers[0].ellipse.centre_px - found.markers[0].centre_px).norm(), 0.05);
}

TEST(MarkerFinder, RegionsLimitTheSearchAndOverlapFindsOnce) {
  Rendering scene(300, 200, 10);
  scene.disc({80, 80}, 10.0, 150);
  scene.disc({200, 120}, 10.0, 150);
  std::mt19937 random(13);
  const auto image = scene.expose(1.0, random);
  MarkerFinder finder{FinderSettings{}};
  const std::vector<Region> overlapping{{60, 60, 100, 100}, {70, 70, 110, 110}};
  const auto found = finder.find(image.view(), overlapping);
  ASSERT_EQ(found.markers.size(), 1U);
  EXPECT_NEAR(found.markers[0].centre_px.x(), 80, 0.1);
  const std::vector<Region> outside{{-50, -50, -10, -10}, {400, 400, 500, 500}};
  EXPECT_TRUE(finder.find(image.view(), outside).markers.empty());
}

TEST(MarkerFinder, GivesTheSameAnswerEveryTime) {
  std::mt19937 random(14);
  const Clutter clutter(random);
  const auto image = clutter.scene.expose(2.0, random);
  MarkerFinder finder{FinderSettings{}};
  const auto first = finder.find(image.view());
  const auto second = finder.find(image.view());
  ASSERT_EQ(first.markers.size(), second.markers.size());
  for (std::size_t i = 0; i < first.markers.size(); ++i)
    EXPECT_EQ(first.markers[i].centre_px, second.markers[i].centre_px);
}

TEST(MarkerFinder, ACoveredDiscIsCutAndItsCentreThatOfTheWhole) {
  std::mt19937 random(15);
  MarkerFinder finder{FinderSettings{}};
  for (const double cut_px : {8.0, 6.0, 4.0, 2.0}) {  // of a radius of 10
    Rendering scene(100, 100, 10);
    scene.cutDisc({50.2, 49.7}, 20.0, cut_px, 180);
    const auto found = finder.find(scene.expose(1.8, random).view());
    ASSERT_EQ(found.markers.size(), 1U) << cut_px;
    EXPECT_TRUE(found.markers[0].cut) << cut_px;
    const Eigen::Vector2d error = found.markers[0].centre_px - Eigen::Vector2d(50.2, 49.7);
    EXPECT_LT(error.norm(), 0.15) << cut_px;
    EXPECT_LT(error.dot(found.markers[0].covariance_px2.inverse() * error), 25.0) << cut_px;
  }
}

TEST(MarkerFinder, LessThanHalfADiscIsNoMarker) {
  Rendering scene(100, 100, 10);
  scene.cutDisc({50, 50}, 20.0, -3.0, 180);
  std::mt19937 random(15);
  const auto found = MarkerFinder{FinderSettings{}}.find(scene.expose(1.0, random).view());
  for (const auto& marker : found.markers) EXPECT_TRUE(marker.cut);
}

TEST(MarkerFinder, SurvivesAnyImage) {
  std::mt19937 random(16);
  for (const bool dark : {false, true}) {
    FinderSettings settings;
    settings.dark_on_bright = dark;
    MarkerFinder finder(settings);
    EXPECT_TRUE(finder.find({}).markers.empty());
    for (const auto& [width, height] :
         {std::pair{1, 1}, {2, 1}, {1, 7}, {33, 31}, {65, 129}, {3, 400}, {321, 3}})
      for (const int kind : {0, 1, 2, 3}) {
        std::vector<std::uint8_t> pixels(static_cast<std::size_t>(width * height), kind == 1 ? 255 : 0);
        if (kind >= 2)
          for (auto& pixel : pixels)
            pixel = static_cast<std::uint8_t>(kind == 2 ? random() : random() % 3 == 0 ? 255 : 0);
        const camera::GreyImage image(width, height, std::move(pixels));
        for (const auto& marker : finder.find(image.view()).markers)
          EXPECT_TRUE(marker.centre_px.allFinite());
      }
  }
}

TEST(MarkerFinder, NoiseAloneHoldsNoMarker) {
  std::mt19937 random(17);
  MarkerFinder finder{FinderSettings{}};
  for (const double sigma : {1.0, 5.0, 20.0})
    EXPECT_TRUE(finder.find(Rendering(400, 300, 30).expose(sigma, random).view()).markers.empty()) << sigma;
}

TEST(MarkerFinder, ALampThatSaturatesIsNamed) {
  Rendering scene(300, 300, 10);
  scene.disc({150, 150}, 120.0, 600);
  std::mt19937 random(18);
  const auto found = MarkerFinder{FinderSettings{}}.find(scene.expose(1.0, random).view());
  EXPECT_TRUE(found.markers.empty());
  EXPECT_EQ(found.rejected[static_cast<std::size_t>(Rejection::kSaturated)], 1);
}

TEST(Rejections, HaveTheirNames) {
  EXPECT_EQ(id(Rejection::kTooSmall), "too_small");
  EXPECT_EQ(id(Rejection::kCut), "cut");
}

}  // namespace
}  // namespace mirrorarm::vision
