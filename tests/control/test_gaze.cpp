#include <gtest/gtest.h>

#include "core/camera/rig_file.h"
#include "core/control/gaze.h"
#include "tests/common/no_heap.h"

namespace mirrorarm::control {
namespace {

/// The rig looks along z of the end effector; the target stands 0.4 m before it.
class GazeTest : public ::testing::Test {
 protected:
  static RigidTransform at(double x_m) {
    return makeTransform(Eigen::Quaterniond::Identity(), {x_m, 0.0, 0.0});
  }

  camera::StereoRig rig_ = *camera::readRig(std::string(RESOURCES) + "/rigs/pinhole.yaml");
  Gaze gaze_{rig_, RigidTransform::Identity()};
  Sight sight_{{0.0, 0.0, 0.4}, 0.06};
};

TEST_F(GazeTest, LeavesGoalsAloneThatSeeTheTarget) {
  EXPECT_GT(gaze_.margin_px(at(0.0), sight_), 50.0);
  const auto kept = gaze_.keep(ToolGoal::resting(at(0.01)), at(0.0), sight_);
  EXPECT_FALSE(kept.shortened);
  EXPECT_TRUE(kept.goal.X_BE.isApprox(at(0.01)));
}

TEST_F(GazeTest, StopsBeforeTheTargetLeavesAnImage) {
  const auto kept = gaze_.keep({at(1.0), at(1.02)}, at(0.0), sight_);
  EXPECT_TRUE(kept.shortened);
  const double x = kept.goal.X_BE.translation().x();
  EXPECT_GT(x, 0.0);
  EXPECT_GT(gaze_.margin_px(kept.goal.X_BE, sight_), 14.0);
  EXPECT_LT(gaze_.margin_px(at(x + 0.01), sight_), 15.0) << "it might have gone on";
  const double speed = (kept.goal.X_BE_soon.translation() - kept.goal.X_BE.translation()).x() / 0.02;
  EXPECT_LT(speed, 1.0) << "slower than was asked";
}

TEST_F(GazeTest, FromWhereItIsNearlyLostItOnlyComesBack) {
  double x = 0.0;
  while (gaze_.margin_px(at(x), sight_) > 0.0) x += 0.01;
  const auto away = gaze_.keep(ToolGoal::resting(at(x + 0.05)), at(x), sight_);
  EXPECT_TRUE(away.shortened);
  EXPECT_TRUE(away.goal.X_BE.isApprox(at(x)));
  const auto back = gaze_.keep(ToolGoal::resting(at(x - 0.01)), at(x), sight_);
  EXPECT_FALSE(back.shortened);
}

TEST_F(GazeTest, BehindTheCamerasNothingIsSeen) {
  sight_.centre_B.z() = -0.4;
  EXPECT_LT(gaze_.margin_px(at(0.0), sight_), 0.0);
}

TEST_F(GazeTest, TakesNothingFromTheHeap) {
  const auto calls = mirrorarm::testing::heapCallsIn(
      [&] { static_cast<void>(gaze_.keep(ToolGoal::resting(at(1.0)), at(0.0), sight_)); });
  EXPECT_EQ(calls, 0U);
}

}  // namespace
}  // namespace mirrorarm::control
