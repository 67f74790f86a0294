#include <random>

#include <gtest/gtest.h>

#include "core/vision/component_scanner.h"

namespace mirrorarm::vision {
namespace {

camera::GreyImage picture(const std::vector<std::string>& rows) {
  std::vector<std::uint8_t> pixels;
  for (const auto& row : rows)
    for (const char c : row) pixels.push_back(c == '#' ? 200 : c == '@' ? 255 : 10);
  return {static_cast<int>(rows[0].size()), static_cast<int>(rows.size()), std::move(pixels)};
}

std::vector<Component> scan(const camera::GreyImage& image, std::uint8_t threshold = 100) {
  ComponentScanner scanner;
  const Brightness brightness{image.view(), 0};
  const auto found = scanner.scan(brightness, brightness.frame(), threshold);
  return {found.begin(), found.end()};
}

TEST(ComponentScanner, JoinsWhatHangsTogetherAlsoByCorners) {
  const auto found = scan(picture({"#..#.....", "#..#...#.", ".##...#..", ".....#..@"}));
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].area_px, 6);
  EXPECT_EQ(found[0].box.right, 3);
  EXPECT_EQ(found[1].area_px, 3);
  EXPECT_EQ(found[2].peak, 255);
  EXPECT_EQ(found[2].clipped_px, 1);
  EXPECT_EQ(found[2].x(), 8.0);
}

TEST(ComponentScanner, AgreesWithFloodFillOnNoise) {
  std::mt19937 random(3);
  const int width = 150, height = 40;
  std::vector<std::uint8_t> pixels(width * height);
  for (auto& pixel : pixels) pixel = random() % 100 < 38 ? 200 : 0;
  const camera::GreyImage image(width, height, pixels);
  int components = 0;
  for (int start = 0; start < width * height; ++start) {
    if (pixels[static_cast<std::size_t>(start)] == 0) continue;
    ++components;
    std::vector<int> open{start};
    pixels[static_cast<std::size_t>(start)] = 0;
    while (!open.empty()) {
      const int at = open.back();
      open.pop_back();
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
          const int x = at % width + dx, y = at / width + dy;
          if (x < 0 || y < 0 || x >= width || y >= height) continue;
          auto& pixel = pixels[static_cast<std::size_t>(y * width + x)];
          if (pixel != 0) open.push_back(y * width + x);
          pixel = 0;
        }
    }
  }
  EXPECT_EQ(static_cast<int>(scan(image).size()), components);
}

TEST(ComponentScanner, MomentsAreThoseOfThePixels) {
  const auto found = scan(picture({"......", ".####.", ".####.", "......"}));
  ASSERT_EQ(found.size(), 1U);
  const Eigen::Matrix2d moments = found[0].moments_px2();
  EXPECT_DOUBLE_EQ(moments(0, 0), 16.0 / 12.0);
  EXPECT_DOUBLE_EQ(moments(1, 1), 4.0 / 12.0);
  EXPECT_DOUBLE_EQ(moments(0, 1), 0.0);
}

}  // namespace
}  // namespace mirrorarm::vision
