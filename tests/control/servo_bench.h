#pragma once

#include <gtest/gtest.h>

#include "core/control/servo_loop.h"
#include "tests/control/fake_robot.h"
#include "tests/robot/arms.h"

namespace mirrorarm::control::testing {

/// Robot, loop and clock at 1 kHz; by default all is well and the robot follows a target.
class ServoBench {
 public:
  static constexpr auto kCycle = std::chrono::milliseconds(1);

  explicit ServoBench(const SupervisorSettings& settings = {},
                      robot::GivesWay gives_way = robot::GivesWay::kNot, const AssistSettings& assist = {})
      : arm(robot::testing::lbr()), limits(*robot::limitsOf("therapy", arm)) {
    robot.gives_way = gives_way;
    loop.emplace(arm, limits, robot, settings, assist);
    run(0.02);
  }

  const ServoState& cycle() {
    now += kCycle;
    robot.now = now;
    if (enabling) loop->setEnabling(*enabling);
    if (frame_comes) last_frame = now;
    if (target_seen && frame_comes) last_target = now;
    if (planner_lives) loop->setTracking({last_frame, last_target, following});
    return state = loop->step(now);
  }

  void run(double seconds) {
    for (double t = 0.0; t < seconds - 1e-9; t += 0.001) cycle();
  }

  /// Cycles until `until` is true of the state; -1 when it never is.
  template <class Until>
  int cyclesUntil(Until until, int most = 3000) {
    for (int i = 1; i <= most; ++i)
      if (until(cycle())) return i;
    return -1;
  }
  int cyclesToStop() {
    return cyclesUntil([](const ServoState& seen) { return seen.stop != StopReason::kNone; });
  }
  int cyclesToRest() {
    return cyclesUntil([](const ServoState& seen) { return seen.at_rest; });
  }

  /// Turns A1 so far that the top speed is reached.
  void setOut(double way_rad = 0.6) {
    robot::Joints goal = state.commanded.q_rad;
    goal[0] += way_rad;
    loop->setTrajectory(robot::Trajectory::quintic(state.commanded, goal, state.time, limits));
  }
  /// Sets out and runs to the top speed.
  void speedUp() {
    setOut();
    run(2.3);
    EXPECT_GT(state.commanded.v_rad_s[0], 0.2);
  }

  robot::ArmDescription arm;
  robot::MotionLimits limits;
  FakeRobot robot{robot::testing::working(), Seconds(0.001)};
  std::optional<ServoLoop> loop;
  TimePoint now{std::chrono::hours(1)};
  TimePoint last_frame = now, last_target = now;
  ServoState state;
  bool following = true;
  bool frame_comes = true;
  bool target_seen = true;
  bool planner_lives = true;
  std::optional<EnablingPosition> enabling =
      EnablingPosition::kEnabled;  ///< what the device says, if it does
};

}  // namespace mirrorarm::control::testing
