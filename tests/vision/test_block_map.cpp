#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "core/vision/block_map.h"
#include "core/vision/component_scanner.h"

namespace mirrorarm::vision {
namespace {

TEST(BlockMap, FollowsUnevenLightAndKeepsAboveNoise) {
  std::mt19937 random(4);
  std::normal_distribution<double> noise(0.0, 3.0);
  const int width = 400, height = 300;
  std::vector<std::uint8_t> pixels;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      pixels.push_back(static_cast<std::uint8_t>(std::clamp(40.0 + 0.3 * x + noise(random), 0.0, 255.0)));
  const camera::GreyImage image(width, height, std::move(pixels));
  const Brightness brightness{image.view(), 0};
  BlockMap map;
  map.read(brightness, brightness.frame());
  EXPECT_NEAR(map.ground(100, 150), 70.0, 6.0);
  EXPECT_NEAR(map.ground(300, 150), 130.0, 6.0);
  EXPECT_NEAR(map.noise(200, 150), 3.5, 1.2);
  ComponentScanner scanner;
  EXPECT_LE(scanner.scan(brightness, map).size(), 3U);
}

TEST(BlockMap, ADiscThatFillsATileDoesNotLiftItsBackground) {
  std::vector<std::uint8_t> pixels(320 * 320, 20);
  for (int y = 0; y < 320; ++y)
    for (int x = 0; x < 320; ++x)
      if (std::hypot(x - 160, y - 160) < 30) pixels[static_cast<std::size_t>(y * 320 + x)] = 220;
  const camera::GreyImage image(320, 320, std::move(pixels));
  const Brightness brightness{image.view(), 0};
  BlockMap map;
  map.read(brightness, brightness.frame());
  EXPECT_LT(map.ground(160, 160), 40.0);
}

TEST(BlockMap, HoldsTheBrightestPixelOfEveryBlockOfOddSizes) {
  std::mt19937 random(5);
  for (const auto& [width, height] : {std::pair{15, 9}, {16, 8}, {17, 7}, {33, 40}, {100, 61}}) {
    std::vector<std::uint8_t> pixels(static_cast<std::size_t>(width * height), 20);
    const auto bright = random() % pixels.size();
    pixels[bright] = 200;
    const camera::GreyImage image(width, height, pixels);
    const Brightness brightness{image.view(), 0};
    BlockMap map;
    map.read(brightness, brightness.frame());
    const int column = static_cast<int>(bright) % width / BlockMap::kWidth_px;
    const int row = static_cast<int>(bright) / width / BlockMap::kHeight_px;
    int standing_out = 0;
    for (int r = 0; r < map.rows(); ++r)
      for (int c = 0; c < map.columns(); ++c) standing_out += map.standsOut(c, r) ? 1 : 0;
    EXPECT_EQ(standing_out, 1) << width << " " << height;
    EXPECT_TRUE(map.standsOut(column, row)) << width << " " << height;
  }
}

TEST(BlockMap, TheNegativeOfADarkImageIsTheSame) {
  std::mt19937 random(6);
  std::vector<std::uint8_t> bright, dark;
  for (int i = 0; i < 200 * 120; ++i) {
    const auto value = static_cast<std::uint8_t>(20 + random() % 9 + (random() % 400 == 0 ? 150 : 0));
    bright.push_back(value);
    dark.push_back(static_cast<std::uint8_t>(255 - value));
  }
  const camera::GreyImage one(200, 120, bright), other(200, 120, dark);
  BlockMap map, negative;
  map.read({one.view(), 0}, {0, 0, 199, 119});
  negative.read({other.view(), 255}, {0, 0, 199, 119});
  for (int row = 0; row < map.rows(); ++row)
    for (int column = 0; column < map.columns(); ++column) {
      EXPECT_EQ(map.standsOut(column, row), negative.standsOut(column, row));
      EXPECT_EQ(map.threshold(column, row), negative.threshold(column, row));
    }
}

}  // namespace
}  // namespace mirrorarm::vision
