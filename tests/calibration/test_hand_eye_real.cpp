#include <cmath>

#include <gtest/gtest.h>

#include "core/calibration/hand_eye.h"
#include "core/calibration/tsai_lenz.h"
#include "tests/calibration/moveit_pairs.h"

namespace mirrorarm::calibration {
namespace {

// 50 real stations, camera beside the robot; expected by the authors' own test to 1 %.
const Eigen::Vector3d kExpected(0.659, -0.249, 0.830);

class MoveItStations : public testing::Test {
 protected:
  void SetUp() override {
    const auto file = std::filesystem::path(SHARED_DATA) / "moveit-handeye/pose_samples.json";
    if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is absent";
    stations_ = readMoveItPairs(file);
  }
  std::vector<PosePair> stations_;
};

TEST_F(MoveItStations, CameraInTheBaseAsTheAuthorsFoundIt) {
  const auto found = solveHandEye(stations_, CameraMount::kToHand);
  ASSERT_TRUE(found);
  const Eigen::Vector3d off = found->X_PC.translation() - kExpected;
  EXPECT_LT(off.norm(), 0.005 * kExpected.norm());
  for (int axis = 0; axis < 3; ++axis) EXPECT_LT(std::abs(off[axis]), 0.005 * std::abs(kExpected[axis]));
  EXPECT_LT(found->rms_m, 0.005);
  EXPECT_TRUE(found->outliers.empty());
}

TEST_F(MoveItStations, AllPairsAgreeWithTheFirstMethod) {
  for (auto& station : stations_) station.X_BF = station.X_BF.inverse();
  const auto X_BC = tsaiLenzOverAllPairs(stations_);
  ASSERT_TRUE(X_BC);
  EXPECT_LT((X_BC->translation() - kExpected).norm(), 0.01 * kExpected.norm());
}

TEST_F(MoveItStations, TakenForACameraInTheHandTheyAreRefused) {
  // Seen alone, these poses may as well be those of a camera in the hand, inverted.
  const auto found = solveHandEye(stations_, CameraMount::kInHand);
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().error, HandEyeError::kCameraInverted);
  EXPECT_NE(reason(found.error()).find("--eye"), std::string::npos);
}

}  // namespace
}  // namespace mirrorarm::calibration
