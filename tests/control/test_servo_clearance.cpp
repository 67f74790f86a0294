#include <gtest/gtest.h>

#include "core/control/servo_loop.h"
#include "tests/common/no_heap.h"
#include "tests/control/fake_robot.h"
#include "tests/robot/arms.h"

namespace mirrorarm::control {
namespace {

using robot::Joints;
using robot::Obstacle;
using robot::ObstacleKind;

const Seconds kCycle(0.001);

/// A servo loop whose arm turns into things.
class Turning {
 public:
  explicit Turning(const std::vector<Obstacle>& obstacles)
      : loop_(arm_, limits_, robot_, {}, {}, robot::Clearance(arm_, {}, obstacles)) {
    run(20);
  }

  void setOut() {
    Joints goal = state.commanded.q_rad;
    goal[0] += 1.0;
    loop_.setTrajectory(robot::Trajectory::quintic(state.commanded, goal, state.time, limits_));
  }
  void run(int cycles) {
    for (int i = 0; i < cycles; ++i) {
      now_ += toClock(kCycle);
      robot_.now = now_;
      loop_.setTracking({now_, now_, false});
      heap_calls += ::mirrorarm::testing::heapCallsIn([&] { state = loop_.step(now_); });
      if (const Joints& a = state.sent.a_rad_s2; a.size() > 0)
        changes += std::abs(a[0] - std::exchange(a_, a[0]));
      while (loop_.takeState()) continue;
    }
  }
  [[nodiscard]] Eigen::Vector3d flange() const { return kinematics_.flange(robot_.q()).translation(); }

  ServoState state;
  double changes = 0.0;  ///< of the acceleration of A1, added up
  std::size_t heap_calls = 0;

 private:
  robot::ArmDescription arm_ = robot::testing::lbr();
  robot::Kinematics kinematics_{arm_};
  robot::MotionLimits limits_ = *robot::limitsOf("therapy", arm_);
  testing::FakeRobot robot_{robot::testing::working(), kCycle};
  ServoLoop loop_;
  TimePoint now_{std::chrono::hours(1)};
  double a_ = 0.0;
};

/// A post on the way of the flange, half of the turn ahead.
Obstacle post(ObstacleKind kind) {
  const robot::ArmDescription arm = robot::testing::lbr();
  Joints ahead = robot::testing::working();
  ahead[0] += 0.5;
  const Eigen::Vector3d centre = robot::Kinematics(arm).flange(ahead).translation();
  return robot::ball(kind, centre, 0.05);
}

}  // namespace

TEST(ServoClearance, TheArmComesToRestBeforeWhatStandsInItsWay) {
  Turning turning({post(ObstacleKind::kBox)});
  turning.setOut();
  int told = 0;
  for (int i = 0; i < 80; ++i) {
    turning.run(100);
    const auto& near = turning.state.guard_contact;
    if (turning.state.guard == robot::GuardAction::kCollision && near->obstacle == ObstacleKind::kBox) ++told;
  }
  EXPECT_GT(told, 10);
  EXPECT_EQ(turning.state.guard_joint, -1);
  EXPECT_LT(turning.changes, 4.0 * 0.5) << "it goes up, down and back once, without chattering";
  const Obstacle stands = post(ObstacleKind::kBox);
  EXPECT_GT((turning.flange() - stands.X_BO.translation()).norm(), 0.05 + 0.02);
  EXPECT_LT(turning.state.sent.v_rad_s.cwiseAbs().maxCoeff(), 0.01);
}

TEST(ServoClearance, TheArmIsSlowPastAHead) {
  Obstacle head = post(ObstacleKind::kHead);
  head.X_BO.translation().z() += 0.15;
  Turning turning({head});
  turning.setOut();
  double fastest_near = 0.0, fastest = 0.0;
  int told = 0;
  for (int i = 0; i < 8000; ++i) {
    const Eigen::Vector3d before = turning.flange();
    turning.run(1);
    const double speed = (turning.flange() - before).norm() / kCycle.count();
    const double off = (turning.flange() - head.X_BO.translation()).norm() - head.round_m;
    const bool near = off < 0.12;  // within the zone, whatever part of the arm is the nearest
    (near ? fastest_near : fastest) = std::max(near ? fastest_near : fastest, speed);
    if (turning.state.guard == robot::GuardAction::kZoneSpeed) ++told;
  }
  EXPECT_GT(fastest, 0.133);
  EXPECT_GT(fastest_near, 0.05);
  EXPECT_LT(fastest_near, 0.1301);
  EXPECT_GT(told, 100);
}

TEST(ServoClearance, AStepTakesNothingFromTheHeap) {
  if (!::mirrorarm::testing::heapIsCounted) GTEST_SKIP() << "a sanitizer owns the heap";
  Turning turning({post(ObstacleKind::kBox), post(ObstacleKind::kHead)});
  turning.setOut();
  turning.heap_calls = 0;
  turning.run(4000);
  EXPECT_EQ(turning.heap_calls, 0U);
}

}  // namespace mirrorarm::control
