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

TEST(ThresholdMap, FollowsUnevenLightAndKeepsAboveNoise) {
  std::mt19937 random(4);
  std::normal_distribution<double> noise(0.0, 3.0);
  const int width = 400, height = 300;
  std::vector<std::uint8_t> pixels;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      pixels.push_back(static_cast<std::uint8_t>(std::clamp(40.0 + 0.3 * x + noise(random), 0.0, 255.0)));
  const camera::GreyImage image(width, height, std::move(pixels));
  const Brightness brightness{image.view(), 0};
  ThresholdMap map;
  map.estimate(brightness, brightness.frame());
  EXPECT_NEAR(map.background(100, 150), 70.0, 6.0);
  EXPECT_NEAR(map.background(300, 150), 130.0, 6.0);
  EXPECT_NEAR(map.noise(200, 150), 3.5, 1.2);
  ComponentScanner scanner;
  EXPECT_LE(scanner.scan(brightness, brightness.frame(), map).size(), 3U);
}

TEST(ThresholdMap, ADiscThatFillsATileDoesNotLiftItsBackground) {
  std::vector<std::uint8_t> pixels(320 * 320, 20);
  for (int y = 0; y < 320; ++y)
    for (int x = 0; x < 320; ++x)
      if (std::hypot(x - 160, y - 160) < 30) pixels[static_cast<std::size_t>(y * 320 + x)] = 220;
  const camera::GreyImage image(320, 320, std::move(pixels));
  const Brightness brightness{image.view(), 0};
  ThresholdMap map;
  map.estimate(brightness, brightness.frame());
  EXPECT_LT(map.background(160, 160), 40.0);
}

}  // namespace
}  // namespace mirrorarm::vision
