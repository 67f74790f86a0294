#include <thread>

#include <gtest/gtest.h>

#include "core/control/servo_loop.h"
#include "tests/common/no_heap.h"
#include "tests/control/fake_robot.h"
#include "tests/robot/arms.h"

namespace mirrorarm::control {
namespace {

using robot::Joints;
using robot::LinkFault;
using robot::Trajectory;

/// Robot, loop and clock; every cycle is checked against the limits.
class Bench {
 public:
  Bench()
      : arm(robot::testing::lbr()),
        limits(*robot::limitsOf("therapy", arm)),
        robot(robot::testing::working()),
        loop(arm, limits, robot, {}) {
    run(0.02);
  }

  const ServoState& cycle() {
    now += toClock(Seconds(0.005));
    robot.now = now;
    if (target_seen) seen_at = now;
    loop.setTracking({seen_at, seen_at, following});
    state = loop.step(now);
    expectLimits(state.commanded.q_rad, state.sent.q_rad.size() > 0);
    return state;
  }

  /// Compares positions, as the robot sees them, not what the loop says of their speed.
  void expectLimits(const Joints& q, bool driven) {
    const bool known = driven && commanded.size() > 0;
    const Joints v = known ? Joints((q - commanded) / 0.005) : Joints();
    if (known) {
      EXPECT_LE(v.cwiseQuotient(limits.max_speed_rad_s).cwiseAbs().maxCoeff(), 1.0 + 1e-4);
    }
    if (known && speed.size() > 0) {
      const Joints a = (v - speed) / 0.005;
      stopped = stopped || state.permit == Permit::kStop;  // from then on the stop's own limits may act
      const robot::MotionLimits allowed = stopped ? robot::brakingLimits(limits) : limits;
      EXPECT_LE(a.cwiseQuotient(allowed.max_acceleration_rad_s2).cwiseAbs().maxCoeff(), 1.0 + 1e-4);
    }
    commanded = driven ? q : Joints();
    speed = v;
  }

  void run(double seconds) {
    for (int i = 0; i < seconds / 0.005 - 1e-9; ++i) cycle();
  }

  /// Seconds until the robot rests.
  double timeToRest() {
    for (int i = 0; i < 1000; ++i)
      if (cycle().at_rest) return i * 0.005;
    return 1e9;
  }

  /// Turns A1 so far that the top speed is reached.
  void setOut() {
    Joints goal = state.commanded.q_rad;
    goal[0] += 0.6;
    loop.setTrajectory(Trajectory::quintic(state.commanded, goal, state.time, limits));
  }

  robot::ArmDescription arm;
  robot::MotionLimits limits;
  testing::FakeRobot robot;
  ServoLoop loop;
  TimePoint now{std::chrono::hours(1)};
  ServoState state;
  TimePoint seen_at{};
  Joints commanded, speed;
  bool stopped = false;
  bool following = false;
  bool target_seen = true;
};

}  // namespace

TEST(ServoLoop, HoldsTheRobotWhereItStands) {
  Bench bench;
  bench.run(1.0);
  EXPECT_LT((bench.robot.q() - robot::testing::working()).norm(), 1e-12);
  EXPECT_TRUE(bench.state.at_rest);
  EXPECT_EQ(bench.state.stop, StopReason::kNone);
  EXPECT_GT(bench.robot.commands, 150);
}

TEST(ServoLoop, FollowsATrajectoryToItsEnd) {
  Bench bench;
  bench.setOut();
  bench.run(1.5);
  EXPECT_FALSE(bench.state.at_rest);
  EXPECT_EQ(bench.state.guard, robot::GuardAction::kPassed);
  bench.run(4.0);
  EXPECT_TRUE(bench.state.at_rest);
  EXPECT_NEAR(bench.robot.q()[0] - robot::testing::working()[0], 0.6, 1e-9);
}

TEST(ServoLoop, StopTakesEffectInTheNextCycleAndEndsWithinLimits) {
  Bench bench;
  bench.setOut();
  bench.run(2.3);
  ASSERT_GT(bench.state.commanded.v_rad_s[0], 0.2);
  const double before = bench.state.commanded.v_rad_s[0];
  bench.loop.stop(StopReason::kOperator);
  EXPECT_EQ(bench.cycle().stop, StopReason::kOperator);
  EXPECT_EQ(bench.state.permit, Permit::kStop);
  EXPECT_LT(bench.state.commanded.v_rad_s[0], before);
  EXPECT_LT(bench.timeToRest(), 0.5);
  EXPECT_EQ(bench.robot.halts, 0);
}

TEST(ServoLoop, ResetNeverStartsAMotion) {
  Bench bench;
  bench.setOut();
  bench.run(1.0);
  bench.loop.stop(StopReason::kOperator);
  bench.loop.stop(StopReason::kInternal);
  bench.run(1.0);
  EXPECT_EQ(bench.state.stop, StopReason::kOperator);
  bench.setOut();  // handed over while stopped
  bench.run(0.1);
  const Joints rest = bench.robot.q();
  bench.loop.resetStop();
  bench.run(1.0);
  EXPECT_EQ(bench.state.stop, StopReason::kNone);
  EXPECT_EQ(bench.robot.q(), rest);
  bench.setOut();
  bench.run(1.0);
  EXPECT_GT((bench.robot.q() - rest).norm(), 0.01);
}

TEST(ServoLoop, ResetWithinTheCycleOfTheStopIsRefused) {
  Bench bench;
  bench.setOut();
  bench.run(1.0);
  bench.loop.stop(StopReason::kOperator);
  bench.loop.resetStop();
  EXPECT_EQ(bench.cycle().stop, StopReason::kOperator);
  EXPECT_EQ(bench.state.reset, ResetRefusal::kMoving);
  EXPECT_LT(bench.timeToRest(), 0.5);
  bench.run(0.5);
  EXPECT_EQ(bench.state.stop, StopReason::kOperator) << "a reset that was refused does not wait";
}

TEST(ServoLoop, OldTargetHoldsAndGoesOnByItself) {
  Bench bench;
  bench.following = true;
  bench.setOut();
  bench.run(2.3);
  const double full = bench.state.commanded.v_rad_s[0];
  bench.target_seen = false;
  bench.run(0.115);
  EXPECT_EQ(bench.state.permit, Permit::kHold);
  EXPECT_LT(bench.state.commanded.v_rad_s[0], full - 0.003);
  bench.target_seen = true;
  bench.run(1.0);
  EXPECT_EQ(bench.state.permit, Permit::kMove);
  EXPECT_EQ(bench.state.stop, StopReason::kNone);
  bench.run(3.0);
  EXPECT_NEAR(bench.robot.q()[0] - robot::testing::working()[0], 0.6, 1e-9);
}

TEST(ServoLoop, LostTargetStops) {
  Bench bench;
  bench.following = true;
  bench.setOut();
  bench.run(2.0);
  bench.target_seen = false;
  bench.run(0.3);
  EXPECT_EQ(bench.state.stop, StopReason::kCameraSilent);
  EXPECT_LT(bench.timeToRest(), 0.5);
}

TEST(ServoLoop, AFewLostAnswersAreBridged) {
  Bench bench;
  bench.setOut();
  bench.run(1.0);
  bench.robot.fault = LinkFault::kNoAnswer;
  bench.run(0.03);
  bench.robot.fault = LinkFault::kNone;
  const Joints rest = bench.robot.q();
  bench.run(0.5);
  EXPECT_EQ(bench.state.stop, StopReason::kNone);
  EXPECT_GT((bench.robot.q() - rest).norm(), 0.01) << "it goes on from rest";
}

TEST(ServoLoop, SilentRobotIsHalted) {
  Bench bench;
  bench.setOut();
  bench.run(1.0);
  bench.robot.fault = LinkFault::kNoAnswer;
  bench.run(0.08);
  EXPECT_EQ(bench.state.stop, StopReason::kRobotSilent);
  EXPECT_GT(bench.robot.halts, 0);
  bench.loop.resetStop();
  bench.run(0.08);
  EXPECT_EQ(bench.state.stop, StopReason::kRobotSilent) << "still silent";
  EXPECT_EQ(bench.state.reset, ResetRefusal::kCausePersists);
  EXPECT_EQ(bench.state.lasting, StopReason::kRobotSilent);
  bench.robot.fault = LinkFault::kNone;
  bench.run(0.05);
  bench.loop.resetStop();
  const Joints rest = bench.robot.q();
  bench.run(0.5);
  EXPECT_EQ(bench.state.stop, StopReason::kNone);
  EXPECT_EQ(bench.robot.q(), rest) << "driven again from where it rests";
}

TEST(ServoLoop, DriveFaultAndNonsenseHaltAtOnce) {
  Bench faulty;
  faulty.setOut();
  faulty.run(1.0);
  faulty.robot.fault = LinkFault::kDriveFault;
  EXPECT_EQ(faulty.cycle().stop, StopReason::kRobotFault);
  EXPECT_EQ(faulty.robot.halts, 1);
  Bench lying;
  lying.run(0.5);
  lying.robot.lies = true;
  EXPECT_EQ(lying.cycle().stop, StopReason::kRobotFault);
  EXPECT_EQ(lying.robot.halts, 1);
}

TEST(ServoLoop, FaultWhileStoppingHalts) {
  Bench bench;
  bench.setOut();
  bench.run(2.0);
  bench.loop.stop(StopReason::kOperator);
  bench.cycle();
  bench.robot.fault = LinkFault::kDriveFault;
  bench.cycle();
  EXPECT_EQ(bench.state.stop, StopReason::kOperator);
  EXPECT_EQ(bench.robot.halts, 1);
}

TEST(ServoLoop, RobotThatDoesNotFollowIsHalted) {
  Bench bench;
  bench.setOut();
  bench.robot.stuck = true;
  bench.run(3.0);
  EXPECT_EQ(bench.state.stop, StopReason::kFollowingError);
  EXPECT_GT(bench.robot.halts, 0);
}

TEST(ServoLoop, MissedBeatHalts) {
  Bench bench;
  bench.setOut();
  bench.run(1.0);
  bench.now += std::chrono::milliseconds(150);
  EXPECT_EQ(bench.cycle().stop, StopReason::kServoLate);
  EXPECT_GT(bench.robot.halts, 0);
}

TEST(ServoLoop, UnevenWakingDoesNotReachTheRobot) {
  Bench bench;
  bench.setOut();
  std::mt19937 random(8);
  int trimmed = 0;
  for (int i = 0; i < 600; ++i) {
    const auto late = std::chrono::microseconds(random() % 3000);
    bench.now += late;
    bench.cycle();
    bench.now -= late;
    if (bench.state.guard != robot::GuardAction::kPassed) ++trimmed;
  }
  EXPECT_LT(trimmed, 200);
}

TEST(ServoLoop, StatesComeOneByOne) {
  Bench bench;
  while (bench.loop.takeState()) continue;
  bench.run(0.05);
  int states = 0;
  while (const auto state = bench.loop.takeState()) ++states;
  EXPECT_EQ(states, 10);
}

TEST(ServoLoop, StepDoesNotAllocate) {
  if (!::mirrorarm::testing::heapIsCounted) GTEST_SKIP() << "a sanitizer owns the heap";
  Bench bench;
  bench.following = true;
  bench.setOut();
  bench.run(0.1);
  std::size_t calls = 0;
  const auto count = [&](int cycles) {
    for (int i = 0; i < cycles; ++i) {
      bench.now += std::chrono::milliseconds(5);
      bench.robot.now = bench.now;
      if (bench.target_seen) bench.loop.setTracking({bench.now, bench.now, true});
      calls += ::mirrorarm::testing::heapCallsIn([&] { bench.state = bench.loop.step(bench.now); });
    }
  };
  count(100);
  bench.setOut();
  count(100);
  bench.target_seen = false;
  count(200);
  bench.robot.fault = LinkFault::kDriveFault;
  count(10);
  EXPECT_EQ(calls, 0U);
}

TEST(ServoLoop, NoSequenceOfEventsBreaksTheLimits) {
  Bench bench;
  std::mt19937 random(21);
  std::uniform_real_distribution<double> way(-0.4, 0.4);
  for (int i = 0; i < 30000; ++i) {
    switch (random() % 400) {
      case 0:
        bench.loop.stop(StopReason::kOperator);
        break;
      case 1:
        bench.following = !bench.following;
        break;
      case 2:
        bench.target_seen = false;
        break;
      case 3:
        bench.robot.fault = LinkFault::kNoAnswer;
        break;
      case 4:
        bench.now += std::chrono::milliseconds(random() % 60);
        break;
      default:
        break;
    }
    if (random() % 60 == 0) {
      bench.loop.resetStop();
      bench.target_seen = true;
      bench.robot.fault = LinkFault::kNone;
    }
    if (random() % 100 == 0) {
      // Planned from anywhere, not only from where the robot is.
      Joints goal = robot::testing::working();
      for (double& angle : goal) angle += way(random);
      bench.loop.setTrajectory(
          Trajectory::quintic(bench.state.commanded, goal, bench.state.time, bench.limits));
    }
    bench.cycle();
  }
  EXPECT_GT(bench.robot.commands, 10000);
}

TEST(ServoLoop, StopsComeFromAnyThread) {
  Bench bench;
  bench.setOut();
  std::atomic<bool> running{true};
  std::jthread nervous([&] {
    while (running) {
      bench.loop.stop(StopReason::kOperator);
      bench.loop.resetStop();
    }
    bench.loop.stop(StopReason::kOperator);
  });
  bench.run(5.0);
  running = false;
  nervous.join();
  EXPECT_EQ(bench.cycle().stop, StopReason::kOperator);
  EXPECT_LT(bench.timeToRest(), 0.5);
}

}  // namespace mirrorarm::control
