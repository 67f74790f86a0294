#include <cmath>

#include <gtest/gtest.h>

#include "ui/model/motion_trace.h"

namespace mirrorarm::ui {
namespace {

station::Snapshot at(double time_s, therapy::Phase phase, double healthy_m, double flange_m) {
  station::Snapshot snapshot;
  snapshot.control.time = TimePoint(toClock(Seconds(time_s)));
  snapshot.control.phase = phase;
  snapshot.control.target_fresh = true;
  snapshot.control.has_goal = phase == therapy::Phase::kTraining;
  snapshot.control.X_BT.translation().x() = 0.5 + healthy_m;
  snapshot.control.X_BF.translation().x() = 0.3 + flange_m;
  snapshot.control.X_BE_goal.translation() = Eigen::Vector3d(0.3 + healthy_m, 0.0, 0.1);
  return snapshot;
}

class Trace : public ::testing::Test {
 protected:
  static RigidTransform sling() {
    RigidTransform X_FE = RigidTransform::Identity();
    X_FE.translation().z() = 0.1;
    return X_FE;
  }
  MotionTrace trace_{sling(), 15.0};
};

TEST_F(Trace, MeasuresFromWhereTheArmsWereAligned) {
  trace_.add(at(1.0, therapy::Phase::kTaught, 0.2, 0.2));
  EXPECT_TRUE(trace_.times().isEmpty()) << "nothing is aligned yet";
  trace_.add(at(2.0, therapy::Phase::kAligned, 0.0, 0.0));
  trace_.add(at(3.0, therapy::Phase::kTraining, 0.060, 0.045));
  ASSERT_EQ(trace_.times().size(), 2);
  EXPECT_NEAR(trace_.times().first(), -1.0, 1e-9);
  EXPECT_NEAR(trace_.healthy_mm().last(), 60.0, 1e-9);
  EXPECT_NEAR(trace_.impaired_mm().last(), 45.0, 1e-9);
  EXPECT_NEAR(trace_.toGoal_mm().last(), 15.0, 1e-9);
  EXPECT_TRUE(std::isnan(trace_.toGoal_mm().first())) << "no goal before training";
}

TEST_F(Trace, LeavesAGapWhereTheTargetIsNotSeen) {
  trace_.add(at(1.0, therapy::Phase::kAligned, 0.0, 0.0));
  auto unseen = at(2.0, therapy::Phase::kTraining, 0.5, 0.01);
  unseen.control.target_fresh = false;
  trace_.add(unseen);
  EXPECT_TRUE(std::isnan(trace_.healthy_mm().last()));
  EXPECT_NEAR(trace_.impaired_mm().last(), 10.0, 1e-9);
}

TEST_F(Trace, KeepsItsWindowAndStartsAnewAfterTeaching) {
  for (int i = 0; i < 1000; ++i) trace_.add(at(0.033 * i, therapy::Phase::kTraining, 0.0, 0.0));
  EXPECT_NEAR(trace_.times().first(), -15.0, 0.04);
  trace_.add(at(40.0, therapy::Phase::kTaught, 0.1, 0.1));
  trace_.add(at(41.0, therapy::Phase::kAligned, 0.1, 0.1));
  ASSERT_EQ(trace_.times().size(), 1);
  EXPECT_NEAR(trace_.healthy_mm().last(), 0.0, 1e-9);
}

TEST_F(Trace, IgnoresTheSameInstantTwice) {
  trace_.add(at(1.0, therapy::Phase::kAligned, 0.0, 0.0));
  trace_.add(at(1.0, therapy::Phase::kAligned, 0.0, 0.0));
  EXPECT_EQ(trace_.times().size(), 1);
}

}  // namespace
}  // namespace mirrorarm::ui
