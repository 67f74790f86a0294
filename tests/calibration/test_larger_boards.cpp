#include <gtest/gtest.h>

#include "core/calibration/board_finder.h"
#include "core/calibration/board_images.h"
#include "core/camera/image_file.h"
#include "core/camera/rig_file.h"
#include "tests/calibration/fuzz.h"
#include "tests/calibration/plate_images.h"
#include "tests/common/scratch_folder.h"

namespace mirrorarm::calibration {
namespace {

namespace fs = std::filesystem;

/// How findBoard() judged the images of a folder.
struct Judged {
  int found = 0, larger = 0, not_found = 0;
  [[nodiscard]] int images() const { return found + larger + not_found; }
};

Judged judged(const fs::path& folder, const Board& board) {
  Judged counts;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".jpg" && entry.path().extension() != ".png") continue;
    const auto image = camera::readImage(entry.path());
    if (!image) continue;
    const auto found = findBoard(image->view(), board);
    if (found)
      ++counts.found;
    else
      ++(found.error() == BoardMiss::kLargerBoard ? counts.larger : counts.not_found);
  }
  return counts;
}

TEST(LargerBoards, RealChessboardsAreToldFromPartsOfThem) {
  const auto folder = fs::path(SHARED_DATA) / "opencv-chess-stereo";
  if (!fs::exists(folder)) GTEST_SKIP() << folder << " is absent";
  const auto whole = judged(folder, *boardOf("chessboard:9x6:0.025"));
  EXPECT_EQ(whole.found, 26);
  EXPECT_EQ(whole.images(), 26);
  const auto part = judged(folder, *boardOf("chessboard:8x6:0.025"));
  EXPECT_EQ(part.found, 0);
  EXPECT_GE(part.larger, 25);
}

TEST(LargerBoards, PartsOfARealChessboardAreRefusedByName) {
  const auto folder = fs::path(SHARED_DATA) / "opencv-chess-stereo";
  if (!fs::exists(folder)) GTEST_SKIP() << folder << " is absent";
  const auto read = readBoardImages(folder / "left0*.jpg", *boardOf("chessboard:7x6:0.025"));
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().file.filename(), "left01.jpg");
  EXPECT_NE(read.error().reason.find("goes on beyond 7x6 points"), std::string::npos) << read.error().reason;
  EXPECT_NE(read.error().reason.find("give the size of the whole board"), std::string::npos);
}

TEST(LargerBoards, ARealPlateOfDarkDotsIsToldFromPartsOfIt) {
  const auto folder = fs::path(SHARED_DATA) / "ucl-dots-metal" / "14_10_22";
  if (!fs::exists(folder)) GTEST_SKIP() << folder << " is absent";
  EXPECT_EQ(judged(folder, *boardOf("circles:16x14:0.01")).found, 2);
  EXPECT_EQ(judged(folder, *boardOf("circles:15x14:0.01")).larger, 2);
  EXPECT_EQ(judged(folder, *boardOf("circles:16x15:0.01")).not_found, 2);
}

class PlateFolder : public testing::Test {
 protected:
  PlateFolder() : bench_(*camera::readRig(fs::path(RESOURCES) / "rigs/pinhole.yaml"), kPlate) {}
  void SetUp() override {
    for (int i = 0; i < 3; ++i) {
      const auto [left, right] = bench_.images(bench_.pose(0.5));
      ASSERT_TRUE(camera::writeImage(folder_ / "left" / (std::to_string(i) + ".png"), left));
      ASSERT_TRUE(camera::writeImage(folder_ / "right" / (std::to_string(i) + ".png"), right));
    }
  }
  [[nodiscard]] FromFile<BoardImages> pairs(const char* board) const {
    return readBoardImagePairs(folder_ / "left", folder_ / "right", *boardOf(board));
  }
  static constexpr Board kPlate{BoardKind::kDotPlate, 9, 7, 0.03};
  test::ScratchFolder folder_;
  PlateBench bench_;
};

TEST_F(PlateFolder, PairsAreReadThoughSomeDotsAreHidden) {
  const auto [left, right] = bench_.images(bench_.pose(0.3), {bench_.someDots(0.3), 0, false});
  ASSERT_TRUE(camera::writeImage(folder_ / "left/9.png", left));
  ASSERT_TRUE(camera::writeImage(folder_ / "right/9.png", right));
  const auto read = pairs("dots:9x7:0.03");
  ASSERT_TRUE(read) << read.error().reason;
  EXPECT_EQ(read->views.size(), 4u);
  EXPECT_GE(seenByBoth(read->views[3]).size(), 30u);
  EXPECT_EQ(leftOut(*read), "");
}

TEST_F(PlateFolder, TooLittleOfAPlateIsNamed) {
  PlateScene scene;
  for (int point = 0; point < 63; ++point)
    if (point % 9 > 3) scene.hidden.push_back(point);
  const auto [left, right] = bench_.images(bench_.pose(0.3), scene);
  ASSERT_TRUE(camera::writeImage(folder_ / "left/9.png", left));
  ASSERT_TRUE(camera::writeImage(folder_ / "right/9.png", right));
  const auto read = pairs("dots:9x7:0.03");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->views.size(), 3u);
  EXPECT_EQ(read->not_found, (std::vector<std::string>{"9.png", "9.png"}));
  EXPECT_NE(leftOut(*read).find("9.png"), std::string::npos);
}

TEST_F(PlateFolder, APlateOfAnotherSizeIsRefused) {
  const auto read = pairs("dots:7x6:0.03");
  ASSERT_FALSE(read);
  EXPECT_NE(read.error().reason.find("beyond 7x6 points"), std::string::npos) << read.error().reason;
}

TEST_F(PlateFolder, WhereNothingIsFoundASmallerBoardIsThoughtOf) {
  const auto read = pairs("circles:11x10:0.03");
  ASSERT_TRUE(read);
  EXPECT_TRUE(read->views.empty());
  EXPECT_NE(leftOut(*read).find("fewer columns or rows than the size asked for"), std::string::npos);
}

TEST_F(PlateFolder, TruncatedImagesAreRefusedByName) {
  const auto file = folder_ / "right/1.png";
  writeText(file, readText(file).substr(0, 2000));
  const auto read = pairs("dots:9x7:0.03");
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().file, file);
  fs::remove(file);
  const auto counted = pairs("dots:9x7:0.03");
  ASSERT_FALSE(counted);
  EXPECT_NE(counted.error().reason.find("holds 2 images where"), std::string::npos);
}

TEST_F(PlateFolder, DamagedImagesNeverCrash) {
  fs::remove(folder_ / "left/1.png");
  fs::remove(folder_ / "left/2.png");
  fuzz(folder_ / "left/0.png", 25, [&](const auto&) {
    const auto read = readBoardImages(folder_ / "left", kPlate);
    EXPECT_TRUE(!read || read->views.size() <= 1);
  });
}

}  // namespace
}  // namespace mirrorarm::calibration
