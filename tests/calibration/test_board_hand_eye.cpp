#include <gtest/gtest.h>

#include "core/calibration/board_hand_eye.h"
#include "tests/calibration/board_views.h"
#include "tests/calibration/stations.h"

namespace mirrorarm::calibration {
namespace {

/// Stations of a robot that is not quite where it says, with a rig on its flange over a board.
struct BoardStationMaker {
  ViewMaker views;
  StationMaker poses;
  CameraMount mount = CameraMount::kInHand;

  explicit BoardStationMaker(unsigned seed, CameraMount where = CameraMount::kInHand) : mount(where) {
    views.rig = trueRig(camera::LensModel::kBrownConrady);
    views.board = {BoardKind::kChessboard, 9, 6, 0.02};
    views.noise_px = 0.05;
    views.random.seed(seed);
    poses.random.seed(seed);
    poses.noise_m = 0.0001;
    poses.noise_deg = 0.02;
    if (mount == CameraMount::kToHand) poses.X_FC.translation() = Eigen::Vector3d(0.9, -0.5, 0.8);
    if (mount == CameraMount::kToHand) poses.X_BM.translation() = Eigen::Vector3d(0.05, 0.02, 0.12);
  }

  HandEyeStation station() {
    for (;;) {
      const RigidTransform X_CM = views.boardPose();
      HandEyeStation made;
      made.view.seen = {};
      if (!views.see(views.rig.left, X_CM, made.view.seen[0]) ||
          !views.see(views.rig.right, views.rig.X_RC * X_CM, made.view.seen[1]))
        continue;
      const RigidTransform X_QP = poses.X_BM * (poses.X_FC * X_CM).inverse();
      made.X_BF = (mount == CameraMount::kInHand ? X_QP : X_QP.inverse()) * poses.noise();
      return made;
    }
  }

  std::vector<HandEyeStation> stations(int count) {
    std::vector<HandEyeStation> made;
    for (int i = 0; i < count; ++i) made.push_back(station());
    return made;
  }
};

double error_m(const BoardHandEye& found, const BoardStationMaker& maker) {
  return (found.hand_eye.X_PC.translation() - maker.poses.X_FC.translation()).norm();
}

TEST(BoardHandEye, IsRightWithinItsCovarianceForBothMounts) {
  for (const auto mount : {CameraMount::kInHand, CameraMount::kToHand})
    for (unsigned seed = 1; seed < 3; ++seed) {
      BoardStationMaker maker(seed, mount);
      const auto found = refineHandEye(maker.views.rig, maker.views.board, maker.stations(15), mount);
      ASSERT_TRUE(found) << reason(found.error());
      ASSERT_TRUE(found->hand_eye.covariance && found->hand_eye.sigma_m);
      EXPECT_LT(error_m(*found, maker), 4.0 * *found->hand_eye.sigma_m);
      EXPECT_LT(error_m(*found, maker), mount == CameraMount::kInHand ? 0.0005 : 0.0009);
      EXPECT_NEAR(found->rms_px, 0.07, 0.015);
      EXPECT_TRUE(found->hand_eye.outliers.empty());
      EXPECT_FALSE(found->board.is_noticed);
      EXPECT_NEAR(found->board.scale, 1.0, 4.0 * found->board.sigma);
      ASSERT_EQ(found->stations_px.size(), 15u);
      for (const auto& px : found->stations_px) EXPECT_NEAR(px.value(), 0.07, 0.03);
    }
}

TEST(BoardHandEye, ABoardOfAnotherSizeIsNoticed) {
  BoardStationMaker maker(5);
  const auto stations = maker.stations(15);
  auto said = maker.views.board;
  said.spacing_m *= 0.99;
  const auto found = refineHandEye(maker.views.rig, said, stations, CameraMount::kInHand);
  ASSERT_TRUE(found) << reason(found.error());
  EXPECT_TRUE(found->board.is_noticed);
  EXPECT_NEAR(found->board.scale, 1.0 / 0.99, 0.001);
  EXPECT_LT(error_m(*found, maker), 0.0005);
}

TEST(BoardHandEye, WrongStationsAndHalfTurnsAreNamed) {
  BoardStationMaker maker(6);
  auto stations = maker.stations(15);
  stations[2].X_BF.translation().y() += 0.05;
  stations[7].view = {};  // no board
  for (auto& sighting : stations[11].view.seen) {
    for (auto& seen : sighting) seen.point = 53 - seen.point;
    std::reverse(sighting.begin(), sighting.end());
  }
  const auto found = refineHandEye(maker.views.rig, maker.views.board, stations, CameraMount::kInHand);
  ASSERT_TRUE(found) << reason(found.error());
  EXPECT_EQ(found->hand_eye.outliers, (std::vector<std::size_t>{2, 7}));
  EXPECT_EQ(found->hand_eye.turned, std::vector<std::size_t>{11});
  EXPECT_FALSE(found->stations_px[2] || found->stations_px[7]);
  EXPECT_NEAR(found->stations_px[11].value(), 0.07, 0.03);
  EXPECT_LT(error_m(*found, maker), 0.0004);
}

TEST(BoardHandEye, RefusalsAreThoseOfThePoses) {
  BoardStationMaker maker(7);
  EXPECT_EQ(refineHandEye(maker.views.rig, maker.views.board, maker.stations(2), CameraMount::kInHand)
                .error()
                .error,
            HandEyeError::kTooFewPairs);
  auto stations = maker.stations(12);
  for (auto& station : stations) station.X_BF = station.X_BF.inverse();
  EXPECT_EQ(refineHandEye(maker.views.rig, maker.views.board, stations, CameraMount::kInHand).error().error,
            HandEyeError::kRobotInverted);
}

}  // namespace
}  // namespace mirrorarm::calibration
