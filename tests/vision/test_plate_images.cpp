#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>

#include "core/camera/image_file.h"
#include "core/vision/marker_finder.h"

namespace mirrorarm::vision {
namespace {

std::vector<Eigen::Vector2d> centresOf(const Detection& found) {
  std::vector<Eigen::Vector2d> centres;
  for (const auto& marker : found.markers) centres.push_back(marker.centre_px);
  return centres;
}

/// Distance to the nearest other centre.
double spacing(const std::vector<Eigen::Vector2d>& centres, std::size_t of) {
  double nearest = 1e9;
  for (std::size_t i = 0; i < centres.size(); ++i)
    if (i != of) nearest = std::min(nearest, (centres[i] - centres[of]).norm());
  return nearest;
}

/// Centres that have neighbours as a grid has: within 40 % of the usual spacing in at least two directions.
std::vector<Eigen::Vector2d> onGrid(const std::vector<Eigen::Vector2d>& centres) {
  std::vector<double> spacings;
  for (std::size_t i = 0; i < centres.size(); ++i) spacings.push_back(spacing(centres, i));
  const auto middle = spacings.begin() + static_cast<std::ptrdiff_t>(spacings.size() / 2);
  std::nth_element(spacings.begin(), middle, spacings.end());
  std::vector<Eigen::Vector2d> kept;
  for (const auto& centre : centres) {
    const auto neighbours = std::count_if(centres.begin(), centres.end(), [&](const auto& other) {
      const double distance = (other - centre).norm();
      return distance > 0.6 * *middle && distance < 1.4 * *middle;
    });
    if (neighbours >= 2) kept.push_back(centre);
  }
  return kept;
}

class Plate : public testing::TestWithParam<const char*> {};

TEST_P(Plate, AllDotsOfTheMetalPlateAreFound) {
  const auto file = std::filesystem::path(SHARED_DATA) / "ucl-dots-metal" / GetParam();
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is absent";
  const auto image = camera::readImage(file);
  ASSERT_TRUE(image);
  const auto centres = centresOf(MarkerFinder(plateSettings()).find(image->view()));
  const auto grid = onGrid(centres);
  constexpr std::size_t kDots = 14 * 16;
  EXPECT_GE(grid.size(), kDots - 2);
  EXPECT_LE(centres.size(), kDots + 3);
}

INSTANTIATE_TEST_SUITE_P(SixImages, Plate,
                         testing::Values("14_10_22/left_image.png", "14_10_22/right_image.png",
                                         "14_11_22/left_image.png", "14_11_22/right_image.png",
                                         "14_12_44/left_image.png", "14_12_44/right_image.png"));

}  // namespace
}  // namespace mirrorarm::vision
