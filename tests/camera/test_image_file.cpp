#include <fstream>
#include <iterator>
#include <random>
#include <unistd.h>

#include <gtest/gtest.h>

#include "core/camera/image_file.h"

namespace mirrorarm::camera {
namespace {

GreyImage slope(int width, int height) {
  std::vector<std::uint8_t> pixels;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) pixels.push_back(static_cast<std::uint8_t>(3 * x + 5 * y));
  return {width, height, std::move(pixels)};
}

std::string bytesOf(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

class ImageFile : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::filesystem::path file() const { return folder_ / (std::string("image") + GetParam()); }

  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("mirrorarm_image_" + std::to_string(::getpid()));
};

TEST_P(ImageFile, ComesBackAsWritten) {
  const auto image = slope(37, 21);
  ASSERT_TRUE(writeImage(file(), image));
  const auto back = readImage(file());
  ASSERT_TRUE(back) << describe(back.error());
  ASSERT_EQ(back->width(), 37);
  ASSERT_EQ(back->height(), 21);
  if (std::string(GetParam()) == ".jpg") return;
  for (int y = 0; y < 21; ++y)
    for (int x = 0; x < 37; ++x) ASSERT_EQ(back->view().at(x, y), image.view().at(x, y));
}

TEST_P(ImageFile, DamageNeverCrashesTheReader) {
  ASSERT_TRUE(writeImage(file(), slope(64, 48)));
  const auto whole = bytesOf(file());
  std::mt19937 random(11);
  for (int i = 0; i < 300; ++i) {
    auto bytes = whole.substr(0, i % 2 == 0 ? random() % whole.size() : whole.size());
    for (int change = 0; change < 3 && !bytes.empty(); ++change)
      bytes[bytes.size() > 40 ? 26 + random() % (bytes.size() - 26) : random() % bytes.size()] =
          static_cast<char>(random() % 256);
    std::ofstream(file(), std::ios::binary) << bytes;
    const auto image = readImage(file());
    if (image) {
      EXPECT_FALSE(image->empty());
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, ImageFile, testing::Values(".png", ".jpg", ".bmp", ".pgm"));

using EveryFormat = ImageFile;

TEST_P(EveryFormat, CutShortIsRefused) {
  ASSERT_TRUE(writeImage(file(), slope(200, 150)));
  const auto whole = bytesOf(file());
  for (const double share : {0.0, 0.1, 0.5, 0.95}) {
    std::ofstream(file(), std::ios::binary)
        << whole.substr(0, static_cast<std::size_t>(share * whole.size()));
    EXPECT_FALSE(readImage(file())) << share;
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, EveryFormat, testing::Values(".png", ".jpg", ".bmp", ".pgm"));

TEST(ImageFileRefusals, NameTheFile) {
  const auto missing = readImage("/nowhere/a.png");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().file, "/nowhere/a.png");
  EXPECT_FALSE(readImage(std::filesystem::temp_directory_path()));
  EXPECT_FALSE(writeImage(std::filesystem::temp_directory_path() / "a.unknown", slope(3, 3)));
  EXPECT_FALSE(writeImage("/proc/a.png", slope(3, 3)));
  EXPECT_FALSE(writeImage(std::filesystem::temp_directory_path() / "a.png", GreyImage()));
}

TEST(ImageFileRefusals, SixteenBitsAreRefused) {
  const auto file =
      std::filesystem::temp_directory_path() / ("sixteen" + std::to_string(::getpid()) + ".pgm");
  std::ofstream(file, std::ios::binary) << "P5\n2 1\n65535\n" << std::string("\x01\x02\x03\x04", 4);
  const auto image = readImage(file);
  std::filesystem::remove(file);
  ASSERT_FALSE(image);
  EXPECT_NE(image.error().reason.find("8-bit"), std::string::npos);
}

}  // namespace
}  // namespace mirrorarm::camera
