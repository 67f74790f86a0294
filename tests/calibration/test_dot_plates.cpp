#include <cmath>
#include <filesystem>
#include <numbers>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

#include "core/calibration/board_finder.h"
#include "core/camera/rig_file.h"
#include "tests/calibration/plate_images.h"

namespace mirrorarm::calibration {
namespace {

const Board kPlate{BoardKind::kDotPlate, 9, 7, 0.03};
constexpr double kTilt_rad = 45.0 * std::numbers::pi / 180.0;

camera::StereoRig rigOf(const std::string& name) {
  const auto rig = camera::readRig(std::filesystem::path(RESOURCES) / "rigs" / (name + ".yaml"));
  EXPECT_TRUE(rig);
  return *rig;
}

/// What the images of a plate gave against the truth.
struct Tally {
  int images = 0, found = 0;
  std::size_t points = 0;
  double squares_px2 = 0.0, normalised = 0.0;

  /// Distance of a point from its truth beyond which it is another one.
  static constexpr double kAnother_px = 2.0;

  void add(const PlateBench& bench, const RigidTransform& X_CM, int camera,
           const Expected<Sighting, BoardMiss>& sighting) {
    ++images;
    if (!sighting) return;
    ++found;
    for (const auto& seen : *sighting) {
      const double error_px = (seen.pixel - bench.truth(X_CM, camera, seen.point)).norm();
      ASSERT_LT(error_px, kAnother_px) << "point " << seen.point;
      ++points;
      squares_px2 += error_px * error_px;
      normalised += error_px * error_px / (2.0 * seen.sigma_px * seen.sigma_px);
    }
  }
  [[nodiscard]] double rms_px() const { return std::sqrt(squares_px2 / static_cast<double>(points)); }
};

class DotPlates : public testing::TestWithParam<const char*> {
 protected:
  Tally shown(int poses, double hidden_share, int lights) {
    Tally tally;
    for (int i = 0; i < poses; ++i) {
      const RigidTransform X_CM = bench_.pose(kTilt_rad);
      const auto [left, right] = bench_.images(X_CM, {bench_.someDots(hidden_share), lights, false});
      tally.add(bench_, X_CM, 0, findBoard(left.view(), kPlate));
      tally.add(bench_, X_CM, 1, findBoard(right.view(), kPlate));
    }
    return tally;
  }
  PlateBench bench_{rigOf(GetParam()), kPlate};
};

INSTANTIATE_TEST_SUITE_P(Rigs, DotPlates, testing::Values("fisheye", "pinhole"),
                         [](const auto& tested) { return std::string(tested.param); });

TEST_P(DotPlates, AreFoundInEveryPoseToTheNoise) {
  const Tally tally = shown(30, 0.0, 0);
  EXPECT_EQ(tally.found, tally.images);
  EXPECT_GT(tally.points, 50u * static_cast<std::size_t>(tally.found));
  EXPECT_LT(tally.rms_px(), 0.02);
  EXPECT_NEAR(tally.normalised / static_cast<double>(tally.points), 1.0, 0.25);
}

TEST_P(DotPlates, HiddenDotsAndLightsBetweenDoNotMislead) {
  const Tally tally = shown(30, 0.2, 20);
  EXPECT_EQ(tally.found, tally.images);
  EXPECT_LT(tally.rms_px(), 0.02);
}

TEST_P(DotPlates, TheirMirrorImageIsNone) {
  for (int i = 0; i < 15; ++i) {
    const auto [left, right] = bench_.images(bench_.pose(kTilt_rad), {{}, 0, true});
    EXPECT_FALSE(findBoard(left.view(), kPlate));
    EXPECT_FALSE(findBoard(right.view(), kPlate));
  }
}

TEST_P(DotPlates, WhatIsLeftOfThemIsToldOrRefusedButNeverMistaken) {
  Tally whole_windows, too_little;
  for (int i = 0; i < 10; ++i) {
    const RigidTransform X_CM = bench_.pose(kTilt_rad);
    for (const int size : {3, 5}) {
      PlateScene scene;
      for (int point = 0; point < 63; ++point)
        if (point % 9 >= size + i % 4 || point % 9 < i % 4 || point / 9 >= size)
          scene.hidden.push_back(point);
      const auto [left, right] = bench_.images(X_CM, scene);
      auto& tally = size == 5 ? whole_windows : too_little;
      tally.add(bench_, X_CM, 0, findBoard(left.view(), kPlate));
      tally.add(bench_, X_CM, 1, findBoard(right.view(), kPlate));
    }
  }
  EXPECT_GT(whole_windows.found, whole_windows.images / 2);
  EXPECT_LT(too_little.found, too_little.images);
}

TEST_P(DotPlates, ALargerPlateIsTold) {
  for (const auto* text : {"dots:8x7:0.03", "dots:9x6:0.03", "dots:6x5:0.03"}) {
    int larger = 0;
    for (int i = 0; i < 5; ++i) {
      const auto [left, right] = bench_.images(bench_.pose(0.5), {bench_.someDots(0.1), 0, false});
      const auto found = findBoard(left.view(), *boardOf(text));
      if (!found) larger += found.error() == BoardMiss::kLargerBoard ? 1 : 0;
    }
    EXPECT_GE(larger, 4) << text;
  }
}

/// Dots of one size: a grid that is no plate.
TEST_P(DotPlates, OtherGridsAreNone) {
  const Board grid{BoardKind::kCircles, 9, 7, 0.03};
  const auto X_CM = makeTransform(Eigen::Quaterniond::Identity(), Eigen::Vector3d(-0.06, -0.09, 0.45));
  simulation::StereoRenderer renderer(rigOf(GetParam()), {}, {});
  simulation::StereoRenderer::Instant dots;
  for (const auto& p_M : boardPoints(grid)) {
    simulation::Patch dot;
    dot.centre = p_M;
    dot.u = 0.006 * Eigen::Vector3d::UnitY();
    dot.v = 0.006 * Eigen::Vector3d::UnitX();
    dots.push_back(transformed(X_CM, dot));
  }
  const auto [left, right] = renderer.render({&dots, 1}, 3);
  EXPECT_FALSE(findBoard(left.view(), kPlate));
  const auto circles = findBoard(right.view(), grid);
  ASSERT_TRUE(circles);
  EXPECT_GT(circles->front().sigma_px, 0.0);
  EXPECT_GT(circles->front().shape_px2.determinant(), 0.0);
}

TEST(BoardFinder, WhateverAnImageHoldsItNeverFails) {
  std::mt19937 random(5);
  for (int i = 0; i < 12; ++i) {
    const int width = 1 + static_cast<int>(random() % 160), height = 1 + static_cast<int>(random() % 120);
    std::vector<std::uint8_t> pixels(static_cast<std::size_t>(width * height));
    const auto grain = 1 + random() % 40;
    std::uint8_t grey = 0;
    for (std::size_t at = 0; at < pixels.size(); ++at) {
      if (at % grain == 0) grey = static_cast<std::uint8_t>(random() % 2 == 0 ? random() % 256 : 255);
      pixels[at] = grey;
    }
    const camera::GreyImage image(width, height, std::move(pixels));
    for (const auto* text :
         {"chessboard:5x4:0.03", "circles:4x4:0.03", "asymmetric-circles:3x5:0.03", "dots:5x4:0.03"}) {
      const auto found = findBoard(image.view(), *boardOf(text));
      EXPECT_TRUE(!found || found->size() <= 20u);
    }
  }
}

}  // namespace
}  // namespace mirrorarm::calibration
