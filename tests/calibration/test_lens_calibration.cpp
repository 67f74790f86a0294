#include <gtest/gtest.h>

#include "core/calibration/camera_calibration.h"
#include "core/calibration/stereo_calibration.h"
#include "tests/calibration/board_views.h"

namespace mirrorarm::calibration {
namespace {

using camera::LensModel;

constexpr ImageSize kSize{1296, 964};
constexpr double kNoise_px = 0.05;

class LensCalibration : public testing::TestWithParam<LensModel> {
 protected:
  /// The board square to the left camera: its size and distance cannot be told from the focal length.
  BoardView flatView() {
    BoardView view{"flat", {}};
    const auto X_CM = makeTransform(Eigen::Quaterniond::Identity(), Eigen::Vector3d(-0.08, -0.06, 0.5));
    EXPECT_TRUE(maker_.see(maker_.rig.left, X_CM, view.seen[0]));
    EXPECT_TRUE(maker_.see(maker_.rig.right, maker_.rig.X_RC * X_CM, view.seen[1]));
    return view;
  }
  void SetUp() override {
    if (GetParam() == LensModel::kKannalaBrandt) maker_.reach = 1.5;
  }
  ViewMaker maker_{trueRig(GetParam())};
};

INSTANTIATE_TEST_SUITE_P(Models, LensCalibration,
                         testing::Values(LensModel::kBrownConrady, LensModel::kKannalaBrandt),
                         [](const auto& tested) { return std::string(camera::name(tested.param)); });

/// Largest distance between where two lenses put a direction, over the part of the image that boards fill
/// [px].
double worstDisagreement_px(const camera::CameraModel& truth, const camera::CameraModel& found) {
  double worst = 0.0;
  for (int x = 200; x <= kSize.width_px - 200; x += 128)
    for (int y = 200; y <= kSize.height_px - 200; y += 94) {
      const Eigen::Vector2d pixel(x, y);
      const auto direction = truth.unproject(pixel);
      const auto back = found.project(direction.value().homogeneous());
      worst = std::max(worst, (back.value() - pixel).norm());
    }
  return worst;
}

TEST_P(LensCalibration, WithoutNoiseTheRigIsExact) {
  const auto found = calibrateStereo(maker_.board, maker_.views(10), kSize, GetParam());
  ASSERT_TRUE(found);
  EXPECT_LT(found->rms_px, 1e-4);
  EXPECT_LT((found->rig.X_RC.translation() - maker_.rig.X_RC.translation()).norm(), 1e-6);
  EXPECT_LT(angleBetween(found->rig.X_RC, maker_.rig.X_RC), 1e-6);
  EXPECT_LT(worstDisagreement_px(maker_.rig.left, found->rig.left), 0.01);
  ASSERT_TRUE(found->hold_out);
  EXPECT_EQ(found->hold_out->parts, 3u);
  EXPECT_EQ(found->hold_out->views, 10u);
  EXPECT_LT(found->hold_out->epipolar_px, 1e-4);
}

TEST_P(LensCalibration, TheMisfitIsTheNoiseAndTheBarComesOut) {
  maker_.noise_px = kNoise_px;
  const auto found = calibrateStereo(maker_.board, maker_.views(24), kSize, GetParam(), 2);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->views, 12u);
  EXPECT_NEAR(found->rms_px, kNoise_px * std::sqrt(2.0), 0.1 * kNoise_px);
  EXPECT_LT((found->rig.X_RC.translation() - maker_.rig.X_RC.translation()).norm(), 0.0002);
  EXPECT_LT(angleBetween(found->rig.X_RC, maker_.rig.X_RC), 0.0006);
  EXPECT_LT(worstDisagreement_px(maker_.rig.left, found->rig.left), 1.0);
  ASSERT_TRUE(found->hold_out);
  EXPECT_EQ(found->hold_out->views, 12u);
  EXPECT_NEAR(found->hold_out->epipolar_px, kNoise_px * std::sqrt(2.0), 0.3 * kNoise_px);
  EXPECT_LT(std::abs(found->hold_out->square_mean_percent), 0.3);
  EXPECT_LT(found->hold_out->square_std_percent, GetParam() == LensModel::kBrownConrady ? 1.0 : 6.0);
  EXPECT_DOUBLE_EQ(found->rig.calibration.hold_out_epipolar_px, found->hold_out->epipolar_px);
}

TEST_P(LensCalibration, OneCameraAlone) {
  maker_.noise_px = kNoise_px;
  auto views = maker_.views(15);
  for (auto& view : views) view.seen[1].clear();
  const auto found = calibrateCamera(maker_.board, views, kSize, GetParam());
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->rms_px, kNoise_px * std::sqrt(2.0), 0.1 * kNoise_px);
  EXPECT_LT(worstDisagreement_px(maker_.rig.left, found->camera), 1.5);
}

TEST_P(LensCalibration, AViewThatMovedBetweenTheCamerasIsNamed) {
  maker_.noise_px = kNoise_px;
  auto views = maker_.views(15);
  for (auto& seen : views[4].seen[1]) seen.pixel += Eigen::Vector2d(0.0, 4.0);
  const auto found = calibrateStereo(maker_.board, views, kSize, GetParam());
  ASSERT_TRUE(found);
  EXPECT_EQ(found->outliers, std::vector<std::string>{"view4"});
  EXPECT_EQ(found->views, 14u);
  EXPECT_NEAR(found->rms_px, kNoise_px * std::sqrt(2.0), 0.1 * kNoise_px);
}

TEST_P(LensCalibration, TooFewOrTooAlikeViewsAreRefused) {
  maker_.noise_px = kNoise_px;
  const auto two = maker_.views(2);
  EXPECT_EQ(calibrateStereo(maker_.board, two, kSize, GetParam()).error().error,
            CalibrationError::kTooFewViews);
  EXPECT_EQ(calibrateStereo(maker_.board, maker_.views(4), kSize, GetParam(), 2).error().error,
            CalibrationError::kTooFewViews);
  EXPECT_EQ(calibrateStereo(maker_.board, maker_.views(4), kSize, GetParam(), 9).error().error,
            CalibrationError::kTooFewViews);
  const std::vector<BoardView> one_again(4, flatView());
  const auto found = calibrateStereo(maker_.board, one_again, kSize, GetParam());
  ASSERT_FALSE(found);
}

TEST_P(LensCalibration, AnotherBoardThanTheRealOneIsRefused) {
  const auto views = maker_.views(8);
  const Board turned{BoardKind::kChessboard, 6, 9, 0.025};
  const auto found = calibrateStereo(turned, views, kSize, GetParam());
  ASSERT_FALSE(found);
  const auto error = found.error().error;
  EXPECT_TRUE(error == CalibrationError::kMisfit || error == CalibrationError::kNotSolved ||
              error == CalibrationError::kViewsTooAlike);
}

}  // namespace
}  // namespace mirrorarm::calibration
