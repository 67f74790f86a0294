#include <gtest/gtest.h>

#include "core/common/time_source.h"
#include "core/control/servo_loop.h"
#include "core/simulation/simulated_robot.h"
#include "tests/robot/arms.h"

namespace mirrorarm::control {
namespace {

using robot::Joints;

/// An arm with drives, which brakes by itself while the line is cut, at the top speed of one joint.
class ShortSilence : public ::testing::TestWithParam<int> {
 protected:
  ShortSilence() {
    run(0.02);
    setOut();
    run(2.3);
  }
  void setOut() {
    Joints goal = state_.commanded.q_rad;
    goal[0] += 0.6;
    loop_.setTrajectory(robot::Trajectory::quintic(state_.commanded, goal, state_.time, limits_));
  }
  void run(double seconds) {
    for (double t = 0.0; t < seconds - 1e-9; t += 0.001) {
      const Joints before = robot_.jointsAt(time_.now());
      time_.set(time_.now() + std::chrono::milliseconds(1));
      state_ = loop_.step(time_.now());
      fastest_rad_s_ =
          std::max(fastest_rad_s_, (robot_.jointsAt(time_.now()) - before).cwiseAbs().maxCoeff() / 0.001);
    }
  }

  ManualTime time_;
  robot::ArmDescription arm_ = robot::testing::lbr();
  robot::MotionLimits limits_ = *robot::limitsOf("therapy", arm_);
  simulation::SimulatedRobot robot_{arm_, robot::testing::working(), time_, {}};
  ServoLoop loop_{arm_, limits_, robot_, {}};
  ServoState state_;
  double fastest_rad_s_ = 0.0;
};

}  // namespace

TEST_P(ShortSilence, NeverMakesTheArmHurryAfterwards) {
  ASSERT_GT(fastest_rad_s_, 0.22);
  robot_.silence(true);
  run(0.001 * GetParam());
  robot_.silence(false);
  run(1.0);
  EXPECT_LE(fastest_rad_s_, 0.25);
  EXPECT_EQ(state_.stop, StopReason::kNone) << id(state_.stop);
  const Joints here = robot_.jointsAt(time_.now());
  setOut();
  run(1.0);
  EXPECT_GT((robot_.jointsAt(time_.now()) - here).norm(), 0.01) << "it goes on: " << id(state_.refused);
}

INSTANTIATE_TEST_SUITE_P(Milliseconds, ShortSilence, ::testing::Values(1, 2, 3, 5, 10, 20, 30, 45));

}  // namespace mirrorarm::control
