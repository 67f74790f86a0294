#include <numbers>

#include <gtest/gtest.h>

#include "core/calibration/drift_check.h"
#include "tests/calibration/board_views.h"

namespace mirrorarm::calibration {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

/// A board on the table, and the robot's grid over it: 20 mm steps, the flange turned a little from plane to
/// plane.
struct GridMaker {
  camera::StereoRig rig = trueRig(camera::LensModel::kBrownConrady);
  Board board{BoardKind::kChessboard, 9, 6, 0.02};
  RigidTransform X_FC = makeTransform(Eigen::Quaterniond(Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ())),
                                      Eigen::Vector3d(-0.06, 0.03, 0.05));
  RigidTransform X_CM0 =
      makeTransform(Eigen::Quaterniond(Eigen::AngleAxisd(0.3, Eigen::Vector3d(1.0, 0.5, 0.0).normalized())),
                    Eigen::Vector3d(-0.03, -0.05, 0.42));

  std::vector<BoardView> views;
  std::vector<RigidTransform> X_BF;

  GridMaker() {
    ViewMaker maker;
    maker.rig = rig;
    maker.board = board;
    maker.noise_px = 0.05;
    const RigidTransform X_BF0 = makeTransform(
        Eigen::Quaterniond(Eigen::AngleAxisd(3.0, Eigen::Vector3d::UnitY())), Eigen::Vector3d(0.5, 0.1, 0.5));
    const RigidTransform X_BM = X_BF0 * X_FC * X_CM0;
    for (int z = 0; z < 3; ++z)
      for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 3; ++x) {
          const Eigen::AngleAxisd turn(0.12 * (z - 1), Eigen::Vector3d(1.0, y, 0.3).normalized());
          const RigidTransform X =
              X_BF0 * makeTransform(Eigen::Quaterniond(turn), 0.02 * Eigen::Vector3d(x - 1, y, z - 1));
          const RigidTransform X_CM = (X * X_FC).inverse() * X_BM;
          BoardView view;
          if (!maker.see(rig.left, X_CM, view.seen[0]) ||
              !maker.see(rig.right, rig.X_RC * X_CM, view.seen[1]))
            continue;
          views.push_back(view);
          X_BF.push_back(X);
        }
  }
};

TEST(DriftCheck, ACalibrationThatHoldsHolds) {
  const GridMaker maker;
  ASSERT_GE(maker.views.size(), 12u);
  const auto found = checkDrift(maker.rig, maker.X_FC, maker.board, maker.views, maker.X_BF);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->verdict, DriftVerdict::kHolds);
  EXPECT_NEAR(found->epipolar_px, 0.07, 0.02);
  EXPECT_NEAR(found->reprojection_px, 0.07, 0.02);
  EXPECT_LT(std::abs(found->length_percent), 0.05);
  EXPECT_EQ(found->points, maker.views.size() * 2 * 54);
  ASSERT_TRUE(found->grid);
  EXPECT_LT(found->grid->std_mm.maxCoeff(), 0.1);
  EXPECT_LT(std::abs(found->grid->scale_percent), 0.2);
  EXPECT_EQ(found->grid->stations, maker.views.size());
}

TEST(DriftCheck, ARigBentByATwentiethOfADegreeFails) {
  const GridMaker maker;
  for (const auto& axis : {Eigen::Vector3d::UnitX().eval(), Eigen::Vector3d::UnitY().eval()}) {
    auto rig = maker.rig;
    rig.X_RC.linear() = Eigen::AngleAxisd(0.05 * kDegree, axis).toRotationMatrix() * rig.X_RC.linear();
    const auto found = checkDrift(rig, maker.X_FC, maker.board, maker.views, maker.X_BF);
    ASSERT_TRUE(found);
    EXPECT_NE(found->verdict, DriftVerdict::kHolds) << axis.transpose();
  }
}

TEST(DriftCheck, AFocalLengthHalfAPercentOffIsNoticed) {
  const GridMaker maker;
  auto lens_of_one = maker.rig.left.intrinsics();
  lens_of_one.fx_px *= 1.005;
  lens_of_one.fy_px *= 1.005;
  auto rig = maker.rig;
  rig.left = camera::CameraModel(lens_of_one);
  const auto one = checkDrift(rig, maker.X_FC, maker.board, maker.views, maker.X_BF);
  ASSERT_TRUE(one);
  EXPECT_EQ(one->verdict, DriftVerdict::kFailed);
  EXPECT_GT(one->epipolar_px, 0.3);
}

TEST(DriftCheck, ACameraShiftedOnTheFlangeIsNoticedWhereTheFlangeTurns) {
  const GridMaker maker;
  auto X_FC = maker.X_FC;
  X_FC.translation().x() += 0.006;
  X_FC.rotate(Eigen::AngleAxisd(0.5 * kDegree, Eigen::Vector3d::UnitY()));
  const auto found = checkDrift(maker.rig, X_FC, maker.board, maker.views, maker.X_BF);
  ASSERT_TRUE(found);
  EXPECT_NE(found->verdict, DriftVerdict::kHolds);
  ASSERT_TRUE(found->grid);
  EXPECT_GT(found->grid->std_mm.maxCoeff(), 0.3);
  EXPECT_LT(found->epipolar_px, 0.15);
}

TEST(DriftCheck, ARobotThatStepsTooFarShowsInTheScale) {
  const GridMaker maker;
  auto X_BF = maker.X_BF;
  for (auto& X : X_BF) X.translation() *= 1.02;
  const auto found = checkDrift(maker.rig, maker.X_FC, maker.board, maker.views, X_BF);
  ASSERT_TRUE(found && found->grid);
  EXPECT_LT(found->grid->scale_percent, -1.0);
  EXPECT_EQ(found->verdict, DriftVerdict::kFailed);
}

TEST(DriftCheck, OneViewTellsOfTheRigAlone) {
  const GridMaker maker;
  const auto found = checkDrift(maker.rig, maker.X_FC, maker.board, std::span(maker.views).first(1), {});
  ASSERT_TRUE(found);
  EXPECT_FALSE(found->grid);
  EXPECT_EQ(found->verdict, DriftVerdict::kHolds);
}

TEST(DriftCheck, NoBoardNoAnswer) {
  const GridMaker maker;
  EXPECT_FALSE(checkDrift(maker.rig, maker.X_FC, maker.board, {}, {}));
  const std::vector<BoardView> empty(2);
  EXPECT_FALSE(checkDrift(maker.rig, maker.X_FC, maker.board, empty, {}));
}

}  // namespace
}  // namespace mirrorarm::calibration
