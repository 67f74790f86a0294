#include <gtest/gtest.h>

#include "core/calibration/record_note.h"
#include "core/calibration/stereo_calibration.h"
#include "tests/calibration/board_views.h"

namespace mirrorarm::calibration {
namespace {

using camera::LensModel;

constexpr ImageSize kSize{1296, 964};

class StereoRefusals : public testing::Test {
 protected:
  StereoRefusals() { maker_.noise_px = 0.05; }

  static void swapRight(std::vector<BoardView>& views, std::size_t i, std::size_t j) {
    std::swap(views[i].seen[1], views[j].seen[1]);
  }
  CalibrationRefusal refusalOf(const std::vector<BoardView>& views, ImageSize size = kSize) {
    const auto found = calibrateStereo(maker_.board, views, size, LensModel::kBrownConrady);
    EXPECT_FALSE(found);
    return found ? CalibrationRefusal{CalibrationError::kNotSolved, {"solved"}} : found.error();
  }
  ViewMaker maker_{trueRig(LensModel::kBrownConrady)};
};

TEST_F(StereoRefusals, SwappedSides) {
  auto views = maker_.views(10);
  for (auto& view : views) std::swap(view.seen[0], view.seen[1]);
  const auto refusal = refusalOf(views);
  EXPECT_EQ(refusal.error, CalibrationError::kSidesSwapped);
  EXPECT_NE(reason(refusal).find("swap the two"), std::string::npos);
}

TEST_F(StereoRefusals, TwoRightImagesExchangedAreNamed) {
  auto views = maker_.views(12);
  swapRight(views, 3, 7);
  const auto refusal = refusalOf(views);
  EXPECT_EQ(refusal.error, CalibrationError::kPairsOutOfOrder);
  EXPECT_EQ(refusal.views,
            (std::vector<std::string>{"view3 fits the partner of view7", "view7 fits the partner of view3"}));
}

TEST_F(StereoRefusals, RightImagesShiftedByOneAreNamed) {
  auto views = maker_.views(10);
  for (std::size_t i = views.size() - 1; i > 0; --i) swapRight(views, i, i - 1);
  const auto refusal = refusalOf(views);
  EXPECT_EQ(refusal.error, CalibrationError::kPairsOutOfOrder);
  ASSERT_GE(refusal.views.size(), 9u);
  EXPECT_EQ(refusal.views[1], "view1 fits the partner of view2");
  EXPECT_NE(reason(refusal).find("and 2 more"), std::string::npos);
}

TEST_F(StereoRefusals, ImagesOfAnotherSizeThanSaid) {
  const auto views = maker_.views(8);
  EXPECT_EQ(refusalOf(views, {648, 482}).error, CalibrationError::kImageSize);
  EXPECT_EQ(refusalOf(views, {2592, 1928}).error, CalibrationError::kImageSize);
}

TEST_F(StereoRefusals, ViewsThatShowTooLittleAreLeftOutByName) {
  auto views = maker_.views(8);
  views[2].seen[1].resize(5);
  views[5].seen[0].clear();
  const auto found = calibrateStereo(maker_.board, views, kSize, LensModel::kBrownConrady);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->outliers, (std::vector<std::string>{"view2", "view5"}));
  for (std::size_t i = 0; i < 5; ++i) views[i].seen[0].clear();
  EXPECT_EQ(refusalOf(views).error, CalibrationError::kTooFewViews);
}

TEST(RecordNote, TheBoardIsWrittenAsItIsRead) {
  for (const auto* text :
       {"chessboard:9x6:0.025", "circles:6x6:0.034", "asymmetric-circles:4x11:0.02", "dots:9x7:0.03"})
    EXPECT_EQ(textOf(boardOf(text).value()), text);
}

}  // namespace
}  // namespace mirrorarm::calibration
