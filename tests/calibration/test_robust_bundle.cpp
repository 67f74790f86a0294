#include <gtest/gtest.h>

#include "core/calibration/lens_numbers.h"
#include "core/calibration/stereo_calibration.h"
#include "core/calibration/view_solution.h"
#include "core/camera/rig_file.h"
#include "core/vision/triangulation.h"
#include "tests/calibration/board_views.h"

namespace mirrorarm::calibration {
namespace {

using camera::LensModel;

constexpr ImageSize kSize{1296, 964};
constexpr double kNoise_px = 0.015;

/// The bench's fisheye rig before a grid of discs.
ViewMaker discMaker(unsigned seed) {
  ViewMaker maker{*camera::readRig(std::string(RESOURCES) + "/rigs/fisheye.yaml")};
  maker.board = {BoardKind::kCircles, 9, 7, 0.03};
  maker.disc_radius_m = 0.009;
  maker.noise_px = kNoise_px;
  maker.reach = 1.3;
  maker.random.seed(seed);
  return maker;
}

/// What the views share, found minus true: lens numbers and a small motion of the bar.
Eigen::VectorXd errorOf(const Bundle& found, const camera::StereoRig& truth) {
  const RigidTransform X_CC = truth.X_RC.inverse() * found.X_RC;
  Eigen::VectorXd error(22);
  error << lensNumbers(found.cameras[0]) - lensNumbers(truth.left.intrinsics()),
      lensNumbers(found.cameras[1]) - lensNumbers(truth.right.intrinsics()), rotationVector(X_CC.linear()),
      X_CC.translation();
  return error;
}

TEST(RobustBundle, TruthLiesWithinTheCovariance) {
  constexpr int kRuns = 4;
  double squares = 0.0;
  for (unsigned run = 0; run < kRuns; ++run) {
    auto maker = discMaker(run);
    const auto solved =
        solveViews(maker.board, maker.views(16), kSize, LensModel::kKannalaBrandt, CameraCount::kTwo);
    ASSERT_TRUE(solved);
    ASSERT_TRUE(solved->fit.covariance);
    EXPECT_NEAR(solved->fit.total_rms_px, kNoise_px * std::sqrt(2.0), 0.1 * kNoise_px);
    EXPECT_NEAR(std::sqrt(solved->fit.variance_factor), kNoise_px, 0.1 * kNoise_px);
    const auto error = errorOf(solved->fit.bundle, maker.rig);
    squares += error.dot(solved->fit.covariance->ldlt().solve(error)) / kRuns;
  }
  EXPECT_GT(squares, 22.0 - 10.0);  // chi squared of 22, its mean over the runs to 3.3
  EXPECT_LT(squares, 22.0 + 10.0);
}

/// Mean error of points all over the paper's cuboid, measured by `found` where `truth` sees them [m].
Eigen::Vector3d biasOver(const camera::StereoRig& truth, const camera::StereoRig& found) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  int count = 0;
  for (double x = -0.03; x <= 0.031; x += 0.02)
    for (double y = -0.03; y <= 0.031; y += 0.02)
      for (double z = 0.38; z <= 0.421; z += 0.02, ++count) {
        const Eigen::Vector3d p_C(0.06 + x, y, z);
        const auto images = vision::imaged(truth, p_C).value();
        vision::DetectedMarker left, right;
        left.centre_px = images.left.pixel;
        right.centre_px = images.right.pixel;
        left.covariance_px2 = right.covariance_px2 = Eigen::Matrix2d::Identity();
        sum += vision::triangulate(found, left, right).value().p_C - p_C;
      }
  return sum / count;
}

TEST(RobustBundle, DiscsGiveTheRigToHundredthsOfAMillimetre) {
  auto maker = discMaker(11);
  const auto views = maker.views(30);
  const auto found = calibrateStereo(maker.board, views, kSize);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->rig.left.intrinsics().model, LensModel::kKannalaBrandt);
  EXPECT_EQ(found->trials.size(), 2u);
  EXPECT_LT(found->rms_px, 0.03);
  EXPECT_LT(found->hold_out->epipolar_px, 0.03);
  EXPECT_LT(found->hold_out->depth_rms_m, 2.5e-4);  // boards to 0.6 m and far aside
  EXPECT_LT(biasOver(maker.rig, found->rig).norm(), 3e-5);
  ASSERT_TRUE(found->board_shape);
  EXPECT_FALSE(found->board_shape->is_bent);
  EXPECT_FALSE(found->board_shape->is_stretched);
}

TEST(RobustBundle, SingleBadPointsAreCountedAndDoLittle) {
  ViewMaker maker{trueRig(LensModel::kBrownConrady)};
  maker.noise_px = 0.05;
  auto views = maker.views(12);
  const auto clean = calibrateStereo(maker.board, views, kSize, LensModel::kBrownConrady);
  views[2].seen[0][10].pixel += Eigen::Vector2d(30.0, -10.0);
  views[2].seen[1][40].pixel += Eigen::Vector2d(0.0, 3.0);
  views[7].seen[1][0].pixel += Eigen::Vector2d(-1.0, 0.0);
  const auto found = calibrateStereo(maker.board, views, kSize, LensModel::kBrownConrady);
  ASSERT_TRUE(clean);
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->outliers.empty());
  EXPECT_EQ(found->residuals[2].outlier_points, 2);
  EXPECT_EQ(found->residuals[7].outlier_points, 1);
  EXPECT_EQ(found->residuals[4].outlier_points, 0);
  EXPECT_LT(found->rms_px, 1.02 * clean->rms_px);
  EXPECT_LT((found->rig.X_RC.translation() - clean->rig.X_RC.translation()).norm(), 2e-5);
}

TEST(RobustBundle, PointsCountByTheirOwnNoise) {
  ViewMaker maker{trueRig(LensModel::kBrownConrady)};
  maker.noise_px = 0.02;
  maker.tells_sigma = true;
  const auto found =
      solveViews(maker.board, maker.views(8), kSize, LensModel::kBrownConrady, CameraCount::kTwo);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->fit.variance_factor, 1.0, 0.15);
}

TEST(BoardShape, ABentBoardIsNoticed) {
  ViewMaker maker{trueRig(LensModel::kBrownConrady)};
  maker.noise_px = 0.05;
  maker.bow_m = 0.0008;
  const auto found = calibrateStereo(maker.board, maker.views(16), kSize, LensModel::kBrownConrady);
  ASSERT_TRUE(found);
  ASSERT_TRUE(found->board_shape);
  EXPECT_TRUE(found->board_shape->is_bent);
  EXPECT_NEAR(found->board_shape->flatness_rms_m, 0.366 * maker.bow_m, 2e-5);  // a parabola of nine columns
  EXPECT_FALSE(found->board_shape->is_stretched);
}

TEST(BoardShape, AStretchedBoardIsNoticed) {
  ViewMaker maker{trueRig(LensModel::kBrownConrady)};
  maker.noise_px = 0.05;
  maker.stretch = -0.004;
  const auto found = calibrateStereo(maker.board, maker.views(16), kSize, LensModel::kBrownConrady);
  ASSERT_TRUE(found);
  ASSERT_TRUE(found->board_shape);
  EXPECT_TRUE(found->board_shape->is_stretched);
  EXPECT_NEAR(found->board_shape->stretch_percent, -0.4, 5.0 * found->board_shape->stretch_sigma_percent);
  EXPECT_FALSE(found->board_shape->is_bent);
}

}  // namespace
}  // namespace mirrorarm::calibration
