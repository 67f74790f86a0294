#include <gtest/gtest.h>

#include "core/calibration/board_images.h"
#include "core/calibration/camera_file.h"
#include "core/calibration/stereo_calibration.h"
#include "core/camera/image_file.h"
#include "tests/calibration/board_views.h"
#include "tests/calibration/fuzz.h"
#include "tests/common/scratch_folder.h"

namespace mirrorarm::calibration {
namespace {

const Board kBoard{BoardKind::kChessboard, 9, 6, 0.025};

void grey(const std::filesystem::path& file, int width_px = 40, int height_px = 30) {
  const auto pixels = static_cast<std::size_t>(width_px * height_px);
  ASSERT_TRUE(camera::writeImage(file, {width_px, height_px, std::vector<std::uint8_t>(pixels, 100)}));
}

std::string refusalOf(const FromFile<BoardImages>& read) {
  return read ? "" : read.error().file.filename().string() + ": " + read.error().reason;
}

TEST(BoardImages, FoldersThatDoNotFitAreRefusedByName) {
  const test::ScratchFolder folder;
  EXPECT_EQ(refusalOf(readBoardImages(folder / "none", kBoard)), "none: is no folder that can be read");
  grey(folder / "left" / "l1.png");
  grey(folder / "left" / "l2.png");
  grey(folder / "right" / "r1.png");
  const auto pairs = [&] {
    return refusalOf(readBoardImagePairs(folder / "left", folder / "right", kBoard));
  };
  EXPECT_NE(pairs().find("right: holds 1 images where"), std::string::npos);
  grey(folder / "right" / "r3.png");
  EXPECT_EQ(pairs(), "l2.png: has no partner among the right images");
  grey(folder / "right" / "r01.png");
  grey(folder / "left" / "l3.png");
  EXPECT_EQ(pairs(), "r1.png: has the same number as r01.png");
  std::filesystem::remove(folder / "right/r01.png");
  grey(folder / "right" / "r2.png", 44, 30);
  EXPECT_NE(pairs().find("r2.png: is 44x30 where"), std::string::npos);
  writeText(folder / "right/r2.png", "no image");
  EXPECT_EQ(pairs(), "r2.png: is no PNG, JPEG, BMP, TIFF or binary PGM image");
}

TEST(BoardImages, WhereNoBoardIsTheNamesAreKept) {
  const test::ScratchFolder folder;
  grey(folder / "both" / "left1.png");
  grey(folder / "both" / "right1.png");
  writeText(folder / "both/notes.txt", "left");
  const auto read = readBoardImagePairs(folder / "both", folder / "both", kBoard);
  ASSERT_TRUE(read);
  EXPECT_TRUE(read->views.empty());
  EXPECT_EQ(read->not_found, (std::vector<std::string>{"left1.png", "right1.png"}));
  EXPECT_EQ(readBoardImages(folder / "both/left*.png", kBoard)->not_found.size(), 1u);
}

class RealChessboards : public testing::TestWithParam<camera::LensModel> {
 protected:
  void SetUp() override {
    const auto folder = std::filesystem::path(SHARED_DATA) / "opencv-chess-stereo";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is absent";
    static const auto read = readBoardImagePairs(folder, folder, kBoard);
    ASSERT_TRUE(read) << read.error().reason;
    images_ = *read;
  }
  BoardImages images_;
};

INSTANTIATE_TEST_SUITE_P(Models, RealChessboards,
                         testing::Values(camera::LensModel::kBrownConrady, camera::LensModel::kKannalaBrandt),
                         [](const auto& tested) { return std::string(camera::name(tested.param)); });

TEST_P(RealChessboards, AllThirteenPairsGiveTheRig) {
  ASSERT_EQ(images_.views.size(), 13u);
  const auto found = calibrateStereo(kBoard, images_.views, images_.size, GetParam());
  ASSERT_TRUE(found);
  EXPECT_LE(found->rms_px, 0.22);
  EXPECT_TRUE(found->outliers.empty());
  EXPECT_NEAR(found->rig.X_RC.translation().norm(), 3.328 * kBoard.spacing_m, 0.02 * kBoard.spacing_m);
}

TEST_P(RealChessboards, OnPairsKeptOutItStillHolds) {
  const auto found = calibrateStereo(kBoard, images_.views, images_.size, GetParam(), 2);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->views, 7u);
  EXPECT_LE(found->hold_out->epipolar_px, 0.20);
  EXPECT_LT(std::abs(found->hold_out->square_mean_percent), 0.3);
  EXPECT_LT(found->hold_out->square_std_percent, 1.0);
}

CameraRecord example(camera::LensModel model) {
  CameraRecord record{trueRig(model).left, {}};
  record.calibration.date = "2026-01-31T09:05:00Z";
  record.calibration.method = "by hand";
  record.calibration.rms_px = 0.2;
  return record;
}

TEST(CameraFile, ComesBackAsWritten) {
  const test::ScratchFolder folder;
  for (const auto model : {camera::LensModel::kBrownConrady, camera::LensModel::kKannalaBrandt}) {
    const auto written = example(model);
    ASSERT_TRUE(writeCameraFile(folder / "camera.yaml", written));
    const auto read = readCameraFile(folder / "camera.yaml");
    ASSERT_TRUE(read) << read.error().reason;
    const auto& lens = read->camera.intrinsics();
    EXPECT_EQ(lens.model, model);
    EXPECT_EQ(lens.width_px, 1296);
    EXPECT_DOUBLE_EQ(lens.fy_px, written.camera.intrinsics().fy_px);
    EXPECT_EQ(lens.distortion, written.camera.intrinsics().distortion);
    EXPECT_EQ(read->calibration.method, "by hand");
    EXPECT_DOUBLE_EQ(read->calibration.rms_px, 0.2);
  }
}

TEST(CameraFile, DamagedFilesNeverCrash) {
  const test::ScratchFolder folder;
  ASSERT_TRUE(writeCameraFile(folder / "camera.yaml", example(camera::LensModel::kKannalaBrandt)));
  fuzz(folder / "camera.yaml", 300, [](const auto& file) {
    const auto read = readCameraFile(file);
    EXPECT_TRUE(!read || read->camera.intrinsics().fx_px > 0.0);
  });
}

}  // namespace
}  // namespace mirrorarm::calibration
