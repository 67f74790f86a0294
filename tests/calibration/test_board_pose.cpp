#include <gtest/gtest.h>

#include "core/calibration/board_pose.h"
#include "core/geometry/small_motion.h"
#include "tests/calibration/board_views.h"

namespace mirrorarm::calibration {
namespace {

using camera::LensModel;

RigidTransform pose() {
  return makeTransform(
      Eigen::Quaterniond(Eigen::AngleAxisd(0.5, Eigen::Vector3d(0.7, -0.6, 0.2).normalized())),
      Eigen::Vector3d(-0.05, -0.03, 0.4));
}

/// Small motion of the board from the truth to what was found, in the board's frame.
SmallMotion errorOf(const RigidTransform& truth, const RigidTransform& found) {
  const RigidTransform X_MM = truth.inverse() * found;
  SmallMotion error;
  error << rotationVector(X_MM.linear()), X_MM.translation();
  return error;
}

ViewMaker discMaker() {
  ViewMaker maker{trueRig(LensModel::kKannalaBrandt)};
  maker.board = {BoardKind::kCircles, 9, 7, 0.02};
  maker.disc_radius_m = 0.0035;
  return maker;
}

TEST(BoardPose, ExactWithoutNoise) {
  for (const auto model : {LensModel::kBrownConrady, LensModel::kKannalaBrandt}) {
    ViewMaker maker{trueRig(model)};
    const auto found = poseBoard(maker.rig, maker.board, maker.view(pose(), "a"));
    ASSERT_TRUE(found);
    EXPECT_LT(errorOf(pose(), found->X_CM).norm(), 1e-9);
    EXPECT_LT(found->rms_px, 1e-7);
  }
}

TEST(BoardPose, DiscsAreFreedOfTheirBias) {
  auto maker = discMaker();
  maker.disc_radius_m = 0.008;
  const auto view = maker.view(pose(), "discs");
  const auto found = poseBoard(maker.rig, maker.board, view);
  ASSERT_TRUE(found);
  const double freed_m = errorOf(pose(), found->X_CM).tail<3>().norm();
  EXPECT_LT(freed_m, 1e-6);
  auto corners = view;
  for (auto& sighting : corners.seen)
    for (auto& seen : sighting) seen.shape_px2.setZero();
  const auto biased = poseBoard(maker.rig, maker.board, corners);
  ASSERT_TRUE(biased);
  EXPECT_GT(errorOf(pose(), biased->X_CM).tail<3>().norm(), 20.0 * freed_m);
}

TEST(BoardPose, CovarianceTellsTheError) {
  constexpr int kRuns = 200;
  for (const bool tells_sigma : {false, true}) {
    auto maker = discMaker();
    maker.noise_px = 0.02;
    maker.tells_sigma = tells_sigma;
    double squares = 0.0;
    for (int run = 0; run < kRuns; ++run) {
      const auto found = poseBoard(maker.rig, maker.board, maker.view(pose(), "noisy"));
      ASSERT_TRUE(found);
      const SmallMotion error = errorOf(pose(), found->X_CM);
      squares += error.dot(found->covariance.ldlt().solve(error)) / kRuns;
    }
    EXPECT_NEAR(squares, 6.0, 1.0) << tells_sigma;  // chi squared of six, its mean to 0.25
  }
}

TEST(BoardPose, SomePointsOfOneImageAreEnough) {
  ViewMaker maker{trueRig(LensModel::kBrownConrady)};
  auto view = maker.view(pose(), "hidden");
  view.seen[1].clear();
  std::erase_if(view.seen[0], [](const SeenPoint& seen) { return seen.point % 7 != 0; });
  const auto found = poseBoard(maker.rig, maker.board, view);
  ASSERT_TRUE(found);
  EXPECT_LT(errorOf(pose(), found->X_CM).norm(), 1e-8);
  std::swap(view.seen[0], view.seen[1]);
  EXPECT_TRUE(poseBoard(maker.rig, maker.board, view));
}

TEST(BoardPose, TheRightOneOfTwoMirroredTiltsIsFound) {
  ViewMaker maker{trueRig(LensModel::kBrownConrady)};
  maker.board.spacing_m = 0.006;
  maker.noise_px = 0.05;
  for (const double tilt : {-0.5, -0.2, 0.2, 0.5}) {
    const auto X_CM = makeTransform(Eigen::Quaterniond(Eigen::AngleAxisd(tilt, Eigen::Vector3d::UnitY())),
                                    Eigen::Vector3d(0.02, -0.01, 0.6));
    const auto found = poseBoard(maker.rig, maker.board, maker.view(X_CM, "far"));
    ASSERT_TRUE(found);
    EXPECT_LT(errorOf(X_CM, found->X_CM).head<3>().norm(), 0.03) << tilt;
  }
}

TEST(BoardPose, NothingWhereThePointsDoNotFixIt) {
  ViewMaker maker{trueRig(LensModel::kBrownConrady)};
  const auto whole = maker.view(pose(), "whole");
  const auto keeping = [&](auto wanted) {
    auto view = whole;
    for (auto& sighting : view.seen)
      std::erase_if(sighting, [&](const SeenPoint& seen) { return !wanted(seen.point); });
    return poseBoard(maker.rig, maker.board, view);
  };
  EXPECT_FALSE(keeping([](int) { return false; }));
  EXPECT_FALSE(keeping([](int point) { return point < 3; }));
  EXPECT_FALSE(keeping([](int point) { return point < 9; }));  // one row
  EXPECT_TRUE(keeping([](int point) { return point < 18; }));
}

}  // namespace
}  // namespace mirrorarm::calibration
