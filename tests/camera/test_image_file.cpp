#include <fstream>
#include <iterator>
#include <random>
#include <unistd.h>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "core/camera/image_file.h"
#include "tests/common/scratch_folder.h"

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

INSTANTIATE_TEST_SUITE_P(Formats, ImageFile, testing::Values(".png", ".jpg", ".bmp", ".pgm", ".tif"));

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

INSTANTIATE_TEST_SUITE_P(Formats, EveryFormat, testing::Values(".png", ".jpg", ".bmp", ".pgm", ".tif"));

TEST(ImageFileRefusals, NameTheFile) {
  const auto missing = readImage("/nowhere/a.png");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().file, "/nowhere/a.png");
  EXPECT_FALSE(readImage(std::filesystem::temp_directory_path()));
  EXPECT_FALSE(writeImage(std::filesystem::temp_directory_path() / "a.unknown", slope(3, 3)));
  EXPECT_FALSE(writeImage("/proc/a.png", slope(3, 3)));
  EXPECT_FALSE(writeImage(std::filesystem::temp_directory_path() / "a.png", GreyImage()));
}

std::string fromHex(const std::string& hex) {
  std::string bytes;
  for (std::size_t i = 0; i < hex.size(); i += 2)
    bytes += static_cast<char>(std::stoi(hex.substr(i, 2), nullptr, 16));
  return bytes;
}

FromFile<GreyImage> readBytes(const std::string& bytes) {
  const test::ScratchFolder scratch;
  return readImage(scratch.holding("image", bytes));
}

std::string refusalOf(const std::string& bytes) {
  const auto image = readBytes(bytes);
  return image ? std::string() : image.error().reason;
}

std::string encoded(const std::string& ending, const cv::Mat& image) {
  std::vector<std::uint8_t> bytes;
  cv::imencode(ending, image, bytes);
  return {bytes.begin(), bytes.end()};
}

const std::string kPngStart = "89504e470d0a1a0a0000000d49484452";
const std::string kPngEnd = "0000000049454e44ae426082";

TEST(ImageFileRefusals, DeepImagesNameTheirDepthAndTheRemedy) {
  const cv::Mat sixteen(5, 7, CV_16U, cv::Scalar(700)), real(5, 7, CV_32F, cv::Scalar(0.4));
  for (const char* ending : {".png", ".tif", ".pgm"}) {
    const auto reason = refusalOf(encoded(ending, sixteen));
    EXPECT_NE(reason.find("16-bit"), std::string::npos) << ending << ": " << reason;
    EXPECT_NE(reason.find("convert"), std::string::npos) << ending << ": " << reason;
    EXPECT_EQ(reason.find('\n'), std::string::npos);
  }
  EXPECT_NE(refusalOf(encoded(".tif", real)).find("32-bit real"), std::string::npos);
}

// A few bytes must not make the reader ask for gigabytes.
TEST(ImageFileRefusals, HugeClaims) {
  const std::string claim = "60000x60000";
  const auto png = fromHex(kPngStart + "0000ea600000ea600800000000a5b92a9e" +
                           "0000000a4944415478da6360040000030002e67da767" + kPngEnd);
  const std::string sixty_thousand("\x60\xea\0\0", 4);
  std::string bmp = "BM" + std::string(16, '\0') + sixty_thousand + sixty_thousand + std::string(20, '\0');
  bmp[14] = 40;
  const std::string tiff = std::string("II*\0\x08\0\0\0\x02\0", 10) +
                           std::string("\0\x01\x04\0\x01\0\0\0", 8) + sixty_thousand +
                           std::string("\x01\x01\x04\0\x01\0\0\0", 8) + sixty_thousand + std::string(4, '\0');
  for (const auto& bytes : {png, bmp, tiff, std::string("P5\n60000 60000\n255\nabc")})
    EXPECT_NE(refusalOf(bytes).find(claim), std::string::npos) << refusalOf(bytes);
}

TEST(ImageFileRefusals, OtherFormatsAreNoImages) {
  for (const char* bytes :
       {"GIF89a\1\0\1", "P2\n2 1\n255\n3 4\n", "#?RADIANCE\n", "index,time_ns\n", "P", "B"})
    EXPECT_NE(refusalOf(bytes).find("binary PGM"), std::string::npos) << bytes;
  EXPECT_FALSE(refusalOf("P5\n0 5\n255\n").empty());
  EXPECT_FALSE(refusalOf("P5\n-3 5\n255\nabc").empty());
}

TEST(ImageFile, PaletteAlphaAndSingleBitsBecomeGrey) {
  const auto palette = readBytes(fromHex(kPngStart + "00000002000000010803000000c3fc8fb8" +
                                         "00000006504c54450a0a0ac8c8c828d1b250" +
                                         "0000000b4944415478da6360600400000400022cde48ad" + kPngEnd));
  ASSERT_TRUE(palette) << describe(palette.error());
  EXPECT_EQ(palette->view().at(0, 0), 10);
  EXPECT_EQ(palette->view().at(1, 0), 200);
  const auto bits = readBytes(fromHex(kPngStart + "0000000900000001010000000024b9b9d0" +
                                      "0000000b4944415478da6358d5000001d7012bfff06755" + kPngEnd));
  ASSERT_TRUE(bits) << describe(bits.error());
  ASSERT_EQ(bits->width(), 9);
  for (int x = 0; x < 9; ++x) EXPECT_EQ(bits->view().at(x, 0), x % 2 == 0 ? 255 : 0);
  const auto alpha = readBytes(fromHex(kPngStart + "000000020000000108040000005e2bb701" +
                                       "0000000d4944415478da63d06038f11f00033401f02d1f2a5e" + kPngEnd));
  ASSERT_TRUE(alpha) << describe(alpha.error());
  EXPECT_EQ(alpha->view().at(0, 0), 40) << "what is transparent keeps its grey";
  EXPECT_EQ(alpha->view().at(1, 0), 200);
}

TEST(ImageFile, TheSmallestAndTheOddestAreRead) {
  for (const auto& [width, height] : {std::pair(1, 1), {1, 97}, {97, 1}, {3, 5}, {641, 1}}) {
    for (const char* ending : {".png", ".jpg", ".bmp", ".pgm", ".tif"}) {
      const auto image = readBytes(encoded(ending, cv::Mat(height, width, CV_8U, cv::Scalar(60))));
      ASSERT_TRUE(image) << ending << describe(image.error());
      EXPECT_EQ(image->width(), width);
      EXPECT_EQ(image->height(), height);
      EXPECT_NEAR(image->view().at(width - 1, height - 1), 60, 1);
    }
  }
}

TEST(ImageFile, ColourBecomesGreyByTheSameWeights) {
  for (const char* ending : {".png", ".jpg", ".bmp", ".tif"}) {
    const auto image = readBytes(encoded(ending, cv::Mat(16, 16, CV_8UC3, cv::Scalar(0, 200, 0))));
    ASSERT_TRUE(image) << ending;
    EXPECT_NEAR(image->view().at(8, 8), 0.587 * 200, 2.0) << ending;
  }
}

// Other decoders fill up what they cannot read and write about it on standard error.
TEST(ImageFileRefusals, DamagedPicturesAreSilentlyRefused) {
  cv::Mat picture(120, 160, CV_8U);
  for (int y = 0; y < picture.rows; ++y)
    for (int x = 0; x < picture.cols; ++x)
      picture.at<std::uint8_t>(y, x) = static_cast<std::uint8_t>((x * x + 3 * y * y) / 7);
  testing::internal::CaptureStderr();
  for (const char* ending : {".jpg", ".tif"}) {
    const auto whole = encoded(ending, picture);
    int refused = 0;
    for (std::size_t hole = 0; hole < whole.size() - 61; hole += 97) {
      auto bytes = whole;
      std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(hole), 60, '\xff');
      refused += refusalOf(bytes).empty() ? 0 : 1;
    }
    EXPECT_GT(refused, 20) << ending;
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace mirrorarm::camera
