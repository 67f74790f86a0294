#include "tests/control/servo_bench.h"

namespace mirrorarm::control {
namespace {

using robot::Joints;
using testing::ServoBench;

constexpr auto kHour = std::chrono::hours(1);

/// At full speed: it must be stopped for this reason within these cycles, and rest.
void expectStopped(ServoBench& bench, StopReason reason, int most_cycles) {
  const int cycles = bench.cyclesToStop();
  EXPECT_GT(cycles, 0);
  EXPECT_LE(cycles, most_cycles);
  EXPECT_EQ(bench.state.stop, reason) << id(bench.state.stop);
  EXPECT_LE(bench.cyclesToRest(), 500);
}

}  // namespace

TEST(BadNews, ARobotThatDoesNotFeelAnyMoreIsHalted) {
  ServoBench bench;
  bench.robot.external_torque_nm = Joints::Zero(7);
  bench.speedUp();
  ASSERT_TRUE(bench.state.assist.force.known);
  bench.robot.external_torque_nm = {};
  expectStopped(bench, StopReason::kRobotFault, 1);
  EXPECT_GT(bench.robot.halts, 0);
  EXPECT_EQ(bench.state.lasting, StopReason::kRobotFault);
}

TEST(BadNews, TorquesOfAnotherArmAreNonsense) {
  ServoBench bench;
  bench.speedUp();
  bench.robot.external_torque_nm = Joints::Zero(6);
  expectStopped(bench, StopReason::kRobotFault, 1);
}

TEST(BadNews, TorquesThatAreNoNumbersAreTooMuch) {
  ServoBench bench;
  bench.speedUp();
  bench.robot.external_torque_nm = Joints::Zero(7);
  bench.robot.external_torque_nm[3] = std::nan("");
  expectStopped(bench, StopReason::kForce, 1);
}

TEST(BadNews, ARobotWithAnotherNumberOfJointsIsHalted) {
  const auto arm = robot::testing::lbr();
  testing::FakeRobot robot(Joints::Zero(6), Seconds(0.001));
  ServoLoop loop(arm, *robot::limitsOf("therapy", arm), robot, {});
  robot.now = TimePoint(kHour);
  loop.setTrajectory(robot::Trajectory::rest(Joints::Zero(6), robot.now));
  const ServoState& state = loop.step(robot.now);
  EXPECT_EQ(state.stop, StopReason::kRobotFault);
  EXPECT_EQ(state.category, StopCategory::kOne);
  EXPECT_GT(robot.halts, 0);
  EXPECT_EQ(robot.commands, 0);
}

TEST(BadNews, AMotionOfAnotherArmIsRefused) {
  ServoBench bench;
  const Joints rest = bench.robot.q();
  bench.loop->setTrajectory(robot::Trajectory::rest(rest.head(6), bench.state.time));
  bench.run(0.1);
  EXPECT_EQ(bench.state.refused, MotionRefusal::kStartElsewhere);
  EXPECT_EQ(bench.robot.q(), rest);
}

TEST(BadNews, AStateToldAgainAndAgainGrowsOld) {
  ServoBench bench;
  bench.speedUp();
  bench.robot.claims = bench.now;
  expectStopped(bench, StopReason::kRobotSilent, 51);
}

TEST(BadNews, TimesFromTheFutureGrowOldToo) {
  ServoBench robot_ahead;
  robot_ahead.speedUp();
  robot_ahead.robot.claims = robot_ahead.now + kHour;
  expectStopped(robot_ahead, StopReason::kRobotSilent, 52);

  ServoBench camera_ahead;
  camera_ahead.speedUp();
  camera_ahead.frame_comes = false;
  camera_ahead.last_frame = camera_ahead.last_target = camera_ahead.now + kHour;
  expectStopped(camera_ahead, StopReason::kCameraSilent, 252);
}

}  // namespace mirrorarm::control
