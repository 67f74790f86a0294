#include <functional>
#include <random>

#include "tests/control/servo_bench.h"

namespace mirrorarm::control {
namespace {

using robot::Joints;
using robot::LinkFault;
using testing::ServoBench;

SupervisorSettings withEnabling() {
  SupervisorSettings settings;
  settings.enabling_needed = true;
  return settings;
}

/// One way to be stopped: what is done to a robot at full speed, and in how many cycles the stop must be
/// latched.
struct Fault {
  StopReason reason;
  StopCategory category;
  int first, last;
  std::function<void(ServoBench&)> inject;
  std::function<void(ServoBench&)> mend;
};

void PrintTo(const Fault& fault, std::ostream* out) { *out << id(fault.reason); }

void nothing(ServoBench&) {}

std::vector<Fault> everyFault() {
  using enum StopReason;
  const auto two = StopCategory::kTwo, one = StopCategory::kOne;
  return {
      {kOperator, two, 1, 1, [](ServoBench& bench) { bench.loop->stop(kOperator); }, nothing},
      {kInternal, two, 1, 1, [](ServoBench& bench) { bench.loop->stop(kInternal); }, nothing},
      {kCameraSilent, two, 251, 252, [](ServoBench& bench) { bench.frame_comes = false; },
       [](ServoBench& bench) { bench.frame_comes = true; }},
      {kTargetLost, two, 251, 252, [](ServoBench& bench) { bench.target_seen = false; },
       [](ServoBench& bench) { bench.target_seen = true; }},
      {kPlannerSilent, two, 151, 152, [](ServoBench& bench) { bench.planner_lives = false; },
       [](ServoBench& bench) { bench.planner_lives = true; }},
      {kRobotSilent, one, 51, 52, [](ServoBench& bench) { bench.robot.fault = LinkFault::kNoAnswer; },
       [](ServoBench& bench) { bench.robot.fault = LinkFault::kNone; }},
      {kRobotFault, one, 1, 1, [](ServoBench& bench) { bench.robot.fault = LinkFault::kDriveFault; },
       [](ServoBench& bench) { bench.robot.fault = LinkFault::kNone; }},
      {kRobotFault, one, 1, 1, [](ServoBench& bench) { bench.robot.fault = LinkFault::kNotReady; },
       [](ServoBench& bench) { bench.robot.fault = LinkFault::kNone; }},
      {kPoorLine, one, 1, 1, [](ServoBench& bench) { bench.robot.fault = LinkFault::kPoorLine; },
       [](ServoBench& bench) { bench.robot.fault = LinkFault::kNone; }},
      {kServoLate, one, 1, 1,
       [](ServoBench& bench) {
         bench.now += std::chrono::milliseconds(101);
         bench.last_frame = bench.last_target = bench.now;
       },
       nothing},
      {kFollowingError, one, 300, 600, [](ServoBench& bench) { bench.robot.stuck = true; },
       [](ServoBench& bench) { bench.robot.stuck = false; }},
      {kEnablingReleased, two, 1, 1, [](ServoBench& bench) { bench.enabling = EnablingPosition::kReleased; },
       [](ServoBench& bench) { bench.enabling = EnablingPosition::kEnabled; }},
      {kEnablingReleased, two, 251, 252, [](ServoBench& bench) { bench.enabling.reset(); },
       [](ServoBench& bench) { bench.enabling = EnablingPosition::kEnabled; }},
      {kEnablingPressedThrough, two, 1, 1,
       [](ServoBench& bench) { bench.enabling = EnablingPosition::kPressedThrough; },
       [](ServoBench& bench) {
         bench.enabling = EnablingPosition::kReleased;
         bench.cycle();
         bench.enabling = EnablingPosition::kEnabled;
       }},
      {kForce, two, 1, 60,
       [](ServoBench& bench) { bench.robot.external_torque_nm = 200.0 * Joints::Ones(7); },
       [](ServoBench& bench) { bench.robot.external_torque_nm = Joints::Zero(7); }},
  };
}

class EveryFault : public ::testing::TestWithParam<Fault> {
 protected:
  /// A stop where nothing moves counts cycles as well.
  int injectAndWait() {
    GetParam().inject(bench_);
    return bench_.cyclesToStop();
  }

  ServoBench bench_{withEnabling()};
};

}  // namespace

TEST_P(EveryFault, IsNoticedInTimeAndEndsInRest) {
  bench_.speedUp();
  const int cycles = injectAndWait();
  EXPECT_GE(cycles, GetParam().first);
  EXPECT_LE(cycles, GetParam().last);
  EXPECT_EQ(bench_.state.stop, GetParam().reason);
  EXPECT_EQ(bench_.state.category, GetParam().category);
  EXPECT_EQ(bench_.robot.halts > 0, GetParam().category == StopCategory::kOne);
  bench_.following = false;  // the session pauses
  EXPECT_LE(bench_.cyclesToRest(), 500);
}

TEST_P(EveryFault, ResetWaitsForRestAndForTheCauseToGoAndStartsNothing) {
  bench_.speedUp();
  injectAndWait();
  bench_.following = false;
  if (!bench_.state.at_rest) bench_.loop->resetStop();
  bench_.cycle();
  EXPECT_EQ(bench_.state.stop, GetParam().reason) << "too early";
  bench_.run(0.7);
  GetParam().mend(bench_);
  bench_.run(2.0);
  ASSERT_EQ(bench_.state.reset, ResetRefusal::kNone) << id(bench_.state.lasting);
  bench_.loop->resetStop();
  bench_.cycle();
  EXPECT_EQ(bench_.state.stop, StopReason::kNone);
  EXPECT_EQ(bench_.state.category, StopCategory::kNone);
  bench_.run(0.1);
  const Joints rest = bench_.robot.q();
  bench_.run(1.0);
  EXPECT_EQ(bench_.robot.q(), rest);
  bench_.setOut();
  bench_.run(1.0);
  EXPECT_GT((bench_.robot.q() - rest).norm(), 0.01) << id(bench_.state.refused);
}

TEST_P(EveryFault, StopsAHeldRobotToo) {
  if (GetParam().reason == StopReason::kFollowingError) return;  // nobody asks it to move
  bench_.speedUp();
  bench_.target_seen = false;
  bench_.run(0.15);
  ASSERT_EQ(bench_.state.permit, Permit::kHold);
  bench_.target_seen = GetParam().reason != StopReason::kTargetLost;
  if (bench_.target_seen) bench_.run(0.05);
  injectAndWait();
  EXPECT_EQ(bench_.state.stop, GetParam().reason);
  bench_.following = false;
  EXPECT_LE(bench_.cyclesToRest(), 500);
}

TEST_P(EveryFault, DuringAnotherStopKeepsTheFirstReasonAndTheGraverCategory) {
  bench_.speedUp();
  bench_.loop->stop(StopReason::kInternal);
  bench_.cycle();
  GetParam().inject(bench_);
  bench_.run(0.6);
  EXPECT_EQ(bench_.state.stop, StopReason::kInternal);
  // A robot that is braking does not leave its commands far enough to be missed.
  if (GetParam().reason != StopReason::kFollowingError) {
    EXPECT_EQ(bench_.state.category, GetParam().category);
  }
  const Joints there = bench_.robot.q();
  bench_.cycle();
  EXPECT_LT((bench_.robot.q() - there).norm(), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Stops, EveryFault, ::testing::ValuesIn(everyFault()),
                         [](const ::testing::TestParamInfo<Fault>& one) {
                           return std::string(id(one.param.reason)) + "_" + std::to_string(one.index);
                         });

TEST(Stops, RestingRobotThatFollowsNobodyIsStoppedByItsOwnFaultsOnly) {
  ServoBench bench;
  bench.following = false;
  bench.cycle();
  bench.frame_comes = bench.planner_lives = false;
  bench.run(2.0);
  EXPECT_EQ(bench.state.stop, StopReason::kNone);
  bench.robot.fault = LinkFault::kNoAnswer;
  EXPECT_EQ(bench.cyclesToStop(), 51);
  EXPECT_EQ(bench.state.stop, StopReason::kRobotSilent);
}

TEST(Stops, SilentCameraEndsInCategoryOneAfterASecond) {
  ServoBench bench;
  bench.speedUp();
  bench.frame_comes = false;
  EXPECT_EQ(bench.cyclesUntil([](const ServoState& seen) { return seen.permit == Permit::kHold; }), 101);
  EXPECT_EQ(bench.cyclesToStop(), 150);
  bench.following = false;
  const int cycles =
      bench.cyclesUntil([](const ServoState& seen) { return seen.category == StopCategory::kOne; });
  EXPECT_EQ(cycles, 750);
  EXPECT_EQ(bench.state.stop, StopReason::kCameraSilent);
  EXPECT_GT(bench.robot.halts, 0);
}

TEST(Stops, RobotThatDoesNotBrakeLosesItsDrives) {
  SupervisorSettings settings;
  settings.braking_time = Seconds(0.1);  // a robot that needs 0.3 s stands for one that brakes badly
  ServoBench bench(settings);
  bench.speedUp();
  bench.loop->stop(StopReason::kOperator);
  EXPECT_EQ(bench.cyclesUntil([](const ServoState& seen) { return seen.category == StopCategory::kOne; }),
            102);
  EXPECT_EQ(bench.state.stop, StopReason::kOperator);
  EXPECT_GT(bench.robot.halts, 0);
}

TEST(Start, WaitsForARobotThatOnlyMonitors) {
  ServoBench bench;
  bench.robot.monitors = true;
  const Joints rest = bench.robot.q();
  const int commands = bench.robot.commands;
  bench.setOut();
  bench.run(0.2);
  EXPECT_EQ(bench.state.refused, MotionRefusal::kRobotNotReady);
  EXPECT_EQ(bench.robot.q(), rest);
  EXPECT_GT(bench.robot.commands, commands) << "it is commanded where it rests";
  bench.robot.monitors = false;
  bench.setOut();
  bench.run(0.5);
  EXPECT_NE(bench.robot.q(), rest);
}

TEST(Start, IsRefusedWhereTheRobotIsNot) {
  ServoBench bench;
  Joints elsewhere = bench.state.commanded.q_rad;
  elsewhere[2] += 0.03;
  const Joints rest = bench.robot.q();
  bench.loop->setTrajectory(robot::Trajectory::rest(elsewhere, bench.state.time));
  bench.run(1.0);
  EXPECT_EQ(bench.state.refused, MotionRefusal::kStartElsewhere);
  EXPECT_EQ(bench.robot.q(), rest);
  EXPECT_EQ(bench.state.stop, StopReason::kNone);
  bench.setOut();
  bench.run(1.0);
  EXPECT_EQ(bench.state.refused, MotionRefusal::kNone);
  EXPECT_GT((bench.robot.q() - rest).norm(), 0.01);
}

TEST(Start, ElsewhereDuringAMotionBrakesToRest) {
  ServoBench bench;
  bench.speedUp();
  bench.loop->setTrajectory(robot::Trajectory::rest(robot::testing::working(), bench.state.time));
  bench.cycle();
  EXPECT_EQ(bench.state.refused, MotionRefusal::kStartElsewhere);
  EXPECT_LE(bench.cyclesToRest(), 500);
}

TEST(Start, NeedsTheEnablingDevice) {
  ServoBench bench(withEnabling());
  bench.following = false;
  bench.cycle();
  bench.enabling = EnablingPosition::kReleased;
  bench.cycle();
  const Joints rest = bench.robot.q();
  bench.setOut();
  bench.run(0.5);
  EXPECT_EQ(bench.state.refused, MotionRefusal::kNotEnabled);
  EXPECT_EQ(bench.state.stop, StopReason::kNone);
  bench.enabling = EnablingPosition::kEnabled;
  bench.run(0.5);
  EXPECT_EQ(bench.robot.q(), rest) << "enabling starts nothing";
  bench.setOut();
  bench.run(1.0);
  EXPECT_GT((bench.robot.q() - rest).norm(), 0.01);
}

TEST(Start, GrowsSoftlyWhateverIsWished) {
  ServoBench bench;
  // A motion that began long ago and is at full speed: only the guard and the soft start stand before it.
  Joints goal = bench.state.commanded.q_rad;
  goal[0] += 0.6;
  const auto motion = robot::Trajectory::quintic(bench.state.commanded, goal, bench.state.time, bench.limits);
  bench.loop->setTrajectory(motion);
  double last = 0.0, steepest = 0.0;
  for (int i = 1; i <= 1000; ++i) {
    bench.cycle();
    const double v = bench.state.commanded.v_rad_s.cwiseAbs().maxCoeff();
    EXPECT_LE(v, 0.24 * (0.011 + 0.001 * i) + 1e-9) << i;
    steepest = std::max(steepest, (v - last) / 0.001);
    last = v;
  }
  EXPECT_LE(steepest, 0.5 * (1.0 + 1e-4));
  EXPECT_DOUBLE_EQ(bench.state.soft_start, 1.0);
}

TEST(Start, AStopDuringItEndsInRestAtOnce) {
  for (const double after_s : {0.001, 0.01, 0.1, 0.4, 0.9}) {
    ServoBench bench;
    bench.setOut();
    bench.run(after_s);
    ASSERT_LT(bench.state.soft_start, 1.0);
    bench.loop->stop(StopReason::kOperator);
    EXPECT_EQ(bench.cyclesToStop(), 1);
    EXPECT_LE(bench.cyclesToRest(), 300) << after_s;
    const Joints rest = bench.robot.q();
    bench.run(0.5);
    EXPECT_LT((bench.robot.q() - rest).norm(), 1e-5) << after_s;
    EXPECT_EQ(bench.state.category, StopCategory::kTwo);
  }
}

TEST(Start, AfterAHoldKeepsTheSpeedThatIsThere) {
  ServoBench bench;
  bench.speedUp();
  bench.target_seen = false;
  bench.run(0.13);
  ASSERT_EQ(bench.state.permit, Permit::kHold);
  const double held = bench.state.commanded.v_rad_s[0];
  ASSERT_GT(held, 0.1);
  bench.target_seen = true;
  bench.cycle();
  EXPECT_NEAR(bench.state.soft_start, held / 0.24, 0.01);
  EXPECT_GE(bench.state.commanded.v_rad_s[0], held - 0.001);  // the braking ends within the jerk limit
}

TEST(Enabling, FromPressedThroughTheWayLeadsOverReleased) {
  EnablingSwitch device(Seconds(0.25));
  TimePoint now{std::chrono::hours(1)};
  const auto say = [&](EnablingPosition position) {
    now += std::chrono::milliseconds(1);
    device.set(position);
    return device.update(now);
  };
  EXPECT_EQ(device.update(now), EnablingPosition::kReleased);
  EXPECT_EQ(say(EnablingPosition::kEnabled), EnablingPosition::kEnabled);
  EXPECT_EQ(say(EnablingPosition::kPressedThrough), EnablingPosition::kPressedThrough);
  EXPECT_EQ(say(EnablingPosition::kEnabled), EnablingPosition::kPressedThrough);
  EXPECT_EQ(say(EnablingPosition::kReleased), EnablingPosition::kReleased);
  EXPECT_EQ(say(EnablingPosition::kEnabled), EnablingPosition::kEnabled);
  EXPECT_EQ(device.update(now + std::chrono::milliseconds(249)), EnablingPosition::kEnabled);
  EXPECT_EQ(device.update(now + std::chrono::milliseconds(251)), EnablingPosition::kReleased);
}

/// Faults of all kinds at random times: from the latched stop on the robot rests within the braking time.
TEST(Stops, NoSequenceOfFaultsLeavesAStoppedRobotMoving) {
  ServoBench bench(withEnabling());
  const auto faults = everyFault();
  std::mt19937 random(77);
  int stopped_for = 0, stops = 0;
  for (int i = 0; i < 60000; ++i) {
    if (random() % 1200 == 0) faults[random() % faults.size()].inject(bench);
    if (bench.state.stop != StopReason::kNone && random() % 400 == 0) {
      for (const Fault& fault : faults) fault.mend(bench);
      bench.loop->resetStop();
    }
    if (bench.state.stop == StopReason::kNone) bench.enabling = EnablingPosition::kEnabled;
    if (random() % 150 == 0) bench.setOut(random() % 2 == 0 ? 0.4 : -0.4);
    bench.following = bench.state.stop == StopReason::kNone;
    const Joints before = bench.robot.q();
    bench.cycle();
    stops += stopped_for == 0 && bench.state.stop != StopReason::kNone ? 1 : 0;
    stopped_for = bench.state.stop == StopReason::kNone ? 0 : stopped_for + 1;
    if (stopped_for > 1000) {
      ASSERT_LT((bench.robot.q() - before).cwiseAbs().maxCoeff(), 1e-5) << i;
    }
  }
  EXPECT_GT(stops, 20);
}

}  // namespace mirrorarm::control
