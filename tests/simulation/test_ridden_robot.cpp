#include <cmath>

#include <gtest/gtest.h>

#include "core/robot/kinematics.h"
#include "core/simulation/bench.h"
#include "core/simulation/bench_layout.h"

namespace mirrorarm::simulation {
namespace {

using robot::LinkFault;

/// A robot that says what it is told to say, and counts what it is asked.
struct ToldRobot final : robot::RobotLink {
  Expected<robot::RobotState, LinkFault> read() noexcept override {
    ++reads;
    if (fault != LinkFault::kNone) return unexpected(LinkFault{fault});
    return state;
  }
  Expected<void, LinkFault> command(const robot::RobotCommand& wish) noexcept override {
    commanded = wish.q_rad;
    return {};
  }
  void halt() noexcept override { ++halts; }
  Seconds period() const noexcept override { return Seconds(0.003); }
  bool takesCommands() const noexcept override { return false; }

  robot::RobotState state;
  LinkFault fault = LinkFault::kNone;
  robot::Joints commanded;
  int reads = 0, halts = 0;
};

class RiddenRobotTest : public ::testing::Test {
 protected:
  RiddenRobotTest() {
    const auto arm = bench_layout::arm(RESOURCES);
    EXPECT_TRUE(arm) << describe(arm.error());
    start_ = *bench_layout::startPosture(robot::Kinematics(*arm));
    tell(start_, 1.0);
  }
  void tell(const robot::Joints& q_rad, double time_s) {
    told_->state = {q_rad, robot::Joints::Zero(q_rad.size()), {}, TimePoint(toClock(Seconds(time_s)))};
  }
  [[nodiscard]] static robot::Joints turned(Eigen::Index joint, double angle_rad) {
    robot::Joints q = robot::Joints::Zero(7);
    q[joint] = angle_rad;
    return q;
  }
  [[nodiscard]] std::string refusal() {
    const auto mounted = RiddenRobot::mount(std::move(link_), start_, Seconds(0.05));
    return mounted ? "" : mounted.error();
  }

  robot::Joints start_;
  std::unique_ptr<robot::RobotLink> link_ = std::make_unique<ToldRobot>();
  ToldRobot* told_ = static_cast<ToldRobot*>(link_.get());
};

TEST_F(RiddenRobotTest, HandsEverythingOnAndReadsOnlyWhenRead) {
  const auto ridden = *RiddenRobot::mount(std::move(link_), start_, Seconds(1.0));
  const int reads = told_->reads;
  tell(start_, 1.004);
  EXPECT_EQ(ridden->read()->measured_at, told_->state.measured_at);
  EXPECT_TRUE(ridden->command({start_, {}}));
  EXPECT_EQ(told_->commanded, start_);
  ridden->halt();
  EXPECT_EQ(told_->halts, 1);
  EXPECT_EQ(ridden->period(), Seconds(0.003));
  EXPECT_FALSE(ridden->takesCommands());
  EXPECT_FALSE(ridden->setsThePace());
  static_cast<void>(ridden->jointsAt(TimePoint{}));
  EXPECT_EQ(told_->reads, reads + 1);
  told_->fault = LinkFault::kPoorLine;
  EXPECT_EQ(ridden->read().error(), LinkFault::kPoorLine);
}

TEST_F(RiddenRobotTest, ARobotThatStandsElsewhereIsRefusedAndNotMoved) {
  tell(start_ + turned(3, -0.2), 1.0);
  EXPECT_NE(refusal().find("start posture"), std::string::npos);
}

TEST_F(RiddenRobotTest, ARobotNearTheStartPostureWillDo) {
  tell(start_.array() + 0.9 * kSamePosture_rad, 1.0);
  EXPECT_EQ(refusal(), "");
}

TEST_F(RiddenRobotTest, AnotherKindOfArmIsRefused) {
  tell(robot::Joints::Zero(6), 1.0);
  EXPECT_NE(refusal().find("has 6 joints"), std::string::npos);
}

TEST_F(RiddenRobotTest, AnglesThatAreNoNumbersAreRefused) {
  tell(robot::Joints::Constant(7, std::nan("")), 1.0);
  EXPECT_NE(refusal().find("not finite"), std::string::npos);
}

TEST_F(RiddenRobotTest, ASilentRobotIsRefused) {
  told_->fault = LinkFault::kNotReady;
  EXPECT_NE(refusal().find("not_ready"), std::string::npos);
}

TEST_F(RiddenRobotTest, TheBenchsWorldRidesOnWhatItMeasures) {
  ManualTime time;
  time.set(TimePoint(toClock(Seconds(1.0))));
  BenchSettings settings;
  settings.resources = RESOURCES;
  settings.own_pace = false;
  const auto bench =
      *Bench::make(settings, time, *RiddenRobot::mount(std::move(link_), start_, Seconds(1.0)));
  const auto begin = bench->truthAt(time.now());
  EXPECT_TRUE(begin.X_BF.isApprox(bench_layout::startX_BF(), 1e-6));
  tell(start_ + turned(0, 0.1), 1.1);
  ASSERT_TRUE(bench->robot().read());
  tell(robot::Joints::Constant(7, std::nan("")), 1.2);  // the servo loop refuses it; the world does not jump
  static_cast<void>(bench->robot().read());
  const auto turn_at = [&](double time_s) {
    const auto truth = bench->truthAt(TimePoint(toClock(Seconds(time_s))));
    return std::atan2(truth.X_BF.translation().y(), truth.X_BF.translation().x());
  };
  EXPECT_NEAR(turn_at(1.05), 0.05, 1e-6);
  EXPECT_NEAR(turn_at(1.3), 0.1, 1e-6);
  time.set(TimePoint(toClock(Seconds(1.3))));
  const auto frame = bench->cameras().next(Seconds(0.0));
  ASSERT_TRUE(frame);
  const auto truth = bench->truthAt(frame->exposed_at);
  const RigidTransform X_CB = (truth.X_BF * bench->X_FC()).inverse();
  for (const auto& disc : truth.discs) {
    const auto pixel = bench->rig().left.project(X_CB * disc.p_B);
    ASSERT_TRUE(pixel);
    EXPECT_GT(frame->left.view().at(static_cast<int>(std::lround(pixel->x())),
                                    static_cast<int>(std::lround(pixel->y()))),
              40);
  }
}

}  // namespace
}  // namespace mirrorarm::simulation
