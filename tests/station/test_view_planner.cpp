#include <gtest/gtest.h>

#include "core/calibration/candidate_views.h"
#include "core/camera/rig_file.h"
#include "core/geometry/rigid_fit.h"
#include "core/robot/urdf.h"
#include "core/simulation/bench_layout.h"
#include "core/station/bench_equipment.h"
#include "core/station/view_planner.h"

namespace mirrorarm::station {
namespace {

namespace layout = simulation::bench_layout;

const calibration::Board kBoard = *calibration::boardOf("dots:9x7:0.03");
const std::filesystem::path kResources = RESOURCES;

class OnTheBench : public ::testing::Test {
 protected:
  robot::ArmDescription arm_ = *robot::readUrdf(kResources / "robots/lbr4plus.urdf");
  robot::Joints home_ = *layout::startPosture(robot::Kinematics(arm_));
  robot::Hand hand_ = *layout::hand(kResources);
  std::vector<robot::Obstacle> surroundings_ = *layout::surroundings(kResources);
  RigidTransform X_BM_ = plateOf(kBoard).X_BM;
  ViewPlanner planner_{
      {arm_, attachedTo(arm_, hand_), surroundings_, *robot::limitsOf("therapy", arm_), {}, 0.0},
      {kBoard, X_BM_, hand_.X_FC}};
};

TEST_F(OnTheBench, HalfOfTheViewsAreInReachAndEveryDirectionHasSome) {
  const auto rig = *camera::readRig(kResources / "rigs/fisheye.yaml");
  const auto points = calibration::boardPoints(kBoard);
  const auto views = calibration::candidateViews(rig, points, 0);
  std::size_t reached = 0, clear = 0;
  std::array<int, 4> quarters{};
  for (const auto& X_CM : views) {
    const auto q = planner_.joints(X_CM, std::array{home_});
    if (!q) continue;
    ++reached;
    if (planner_.path(home_, *q)) ++clear;
    const Eigen::Vector3d camera_M = X_CM.inverse().translation() - centroid(points);
    ++quarters[(camera_M.x() > 0.0 ? 1u : 0u) + (camera_M.y() > 0.0 ? 2u : 0u)];
    const RigidTransform X_there = planner_.viewFrom(planner_.flange(*q));
    EXPECT_LT((X_there.translation() - X_CM.translation()).norm(), 2e-4);
  }
  EXPECT_GT(reached, views.size() / 2);
  EXPECT_EQ(clear, reached);
  for (const int count : quarters) EXPECT_GT(count, 10);
}

TEST_F(OnTheBench, ViewsFromBehindTheBoardOrInsideItAreOutOfReach) {
  const RigidTransform X_CM_start = planner_.viewFrom(planner_.flange(home_));
  EXPECT_TRUE(planner_.joints(X_CM_start, std::array{home_}));
  RigidTransform X_CM_close = X_CM_start;
  X_CM_close.translation().z() = 0.03;
  EXPECT_FALSE(planner_.joints(X_CM_close, std::array{home_}));
  const RigidTransform behind =
      X_CM_start * Eigen::AngleAxisd(3.1, Eigen::Vector3d::UnitX()) * Eigen::Translation3d(0.0, 0.0, 0.5);
  EXPECT_FALSE(planner_.joints(behind, std::array{home_}));
}

TEST(BoardObstacles, ABoardOnTheTableHasNoPost) {
  const RigidTransform X_BM(Eigen::Translation3d(0.5, 0.0, -0.01));
  EXPECT_EQ(boardObstacles(kBoard, X_BM, 0.0).size(), 1u);
  const auto obstacles = boardObstacles(kBoard, RigidTransform(Eigen::Translation3d(0.5, 0.0, 0.3)), 0.0);
  ASSERT_EQ(obstacles.size(), 2u);
  EXPECT_NEAR(obstacles[1].size_m.z(), 0.3, 1e-12);
}

}  // namespace
}  // namespace mirrorarm::station
