#include <cmath>

#include <gtest/gtest.h>

#include "core/robot/urdf.h"
#include "core/simulation/simulated_robot.h"

namespace mirrorarm::simulation {
namespace {

constexpr auto kCycle = std::chrono::milliseconds(5);

class SimulatedRobotTest : public ::testing::Test {
 protected:
  static robot::Joints startAngles() {
    robot::Joints q(7);
    q << 0.0, -0.5, 0.0, 1.4, 0.0, -1.2, 0.0;
    return q;
  }
  void SetUp() override { time_.set(fromNanoseconds(1'000'000'000)); }
  robot::RobotState cycle() {
    time_.set(time_.now() + kCycle);
    return *robot_.read();
  }

  ManualTime time_;
  robot::ArmDescription arm_ = *robot::readUrdf(std::filesystem::path(RESOURCES) / "robots/lbr4plus.urdf");
  SimulatedRobot robot_{arm_, startAngles(), time_, {.seed = 5}};
};

TEST_F(SimulatedRobotTest, RestsUntilItIsCommanded) {
  for (int i = 0; i < 100; ++i) EXPECT_LT((cycle().q_rad - startAngles()).cwiseAbs().maxCoeff(), 1e-4);
}

TEST_F(SimulatedRobotTest, FollowsWithASmallLag) {
  double worst = 0.0;
  for (int i = 0; i < 600; ++i) {
    const double t = 0.005 * i, ramp = 0.1 * (t < 1.0 ? 0.5 * t * t : t - 0.5);
    const auto state = cycle();
    robot::Joints wish = startAngles();
    wish[0] += ramp;
    ASSERT_TRUE(robot_.command({wish}));
    if (t > 1.5) worst = std::max(worst, std::abs((wish[0] - state.q_rad[0]) / 0.1 - 0.026));
  }
  EXPECT_LT(worst, 0.008);  // two cycles and 13 ms, in seconds
}

TEST_F(SimulatedRobotTest, KeepsItsDrivesSpeed) {
  robot::Joints far = startAngles();
  far[0] += 2.0;
  double fastest = 0.0;
  auto state = cycle();
  for (int i = 0; i < 800; ++i) {
    ASSERT_TRUE(robot_.command({far}));
    state = cycle();
    fastest = std::max(fastest, std::abs(state.v_rad_s[0]));
  }
  EXPECT_LE(fastest, arm_.joints[0].max_speed_rad_s + 1e-3);
  EXPECT_GT(fastest, 0.9 * arm_.joints[0].max_speed_rad_s);
  EXPECT_NEAR(state.q_rad[0], far[0], 1e-3);
}

TEST_F(SimulatedRobotTest, HaltBrakesAndStays) {
  robot::Joints wish = startAngles();
  for (int i = 0; i < 200; ++i) {
    static_cast<void>(cycle());
    wish[0] += 0.001;
    ASSERT_TRUE(robot_.command({wish}));
  }
  robot_.halt();
  const double stopped_at = cycle().q_rad[0];
  for (int i = 0; i < 40; ++i) {
    robot_.halt();
    static_cast<void>(cycle());
  }
  const auto rest = cycle();
  EXPECT_LT(std::abs(rest.v_rad_s[0]), 1e-3);
  EXPECT_LT(rest.q_rad[0] - stopped_at, 0.2 * 0.2 / (2.0 * 5.0));
}

TEST_F(SimulatedRobotTest, SilenceGivesNoAnswerAndBrakes) {
  robot::Joints wish = startAngles();
  for (int i = 0; i < 200; ++i) {
    static_cast<void>(cycle());
    wish[3] += 0.001;
    ASSERT_TRUE(robot_.command({wish}));
  }
  robot_.silence(true);
  for (int i = 0; i < 60; ++i) {
    time_.set(time_.now() + kCycle);
    EXPECT_EQ(robot_.read().error(), robot::LinkFault::kNoAnswer);
    wish[3] += 0.001;
    EXPECT_EQ(robot_.command({wish}).error(), robot::LinkFault::kNoAnswer);
  }
  robot_.silence(false);
  EXPECT_LT(cycle().v_rad_s.cwiseAbs().maxCoeff(), 1e-3);
}

TEST_F(SimulatedRobotTest, IgnoresWishesThatAreNone) {
  robot::Joints wish = startAngles();
  wish[2] = std::nan("");
  EXPECT_EQ(robot_.command({wish}).error(), robot::LinkFault::kDriveFault);
  EXPECT_EQ(robot_.command({robot::Joints::Zero(6)}).error(), robot::LinkFault::kDriveFault);
  for (int i = 0; i < 20; ++i) EXPECT_LT((cycle().q_rad - startAngles()).cwiseAbs().maxCoeff(), 1e-4);
}

TEST_F(SimulatedRobotTest, RemembersWhereItWas) {
  robot::Joints wish = startAngles();
  std::vector<robot::RobotState> states;
  for (int i = 0; i < 400; ++i) {
    states.push_back(cycle());
    wish[5] += 0.0008;
    ASSERT_TRUE(robot_.command({wish}));
  }
  for (const auto& state : states)
    EXPECT_LT((robot_.jointsAt(state.measured_at) - state.q_rad).cwiseAbs().maxCoeff(), 1e-4);
}

TEST_F(SimulatedRobotTest, BadLineLosesAndRepeatsAnswers) {
  robot_.disturbLine({.lost_share = 0.2, .late_share = 0.3});
  int lost = 0, late = 0;
  TimePoint newest{};
  for (int i = 0; i < 2000; ++i) {
    time_.set(time_.now() + std::chrono::milliseconds(1));
    const auto state = robot_.read();
    if (!state) {
      ++lost;
      continue;
    }
    if (state->measured_at == newest) ++late;
    newest = state->measured_at;
  }
  EXPECT_NEAR(lost, 400, 60);
  EXPECT_NEAR(late, 600, 80);
  robot_.disturbLine({});
  const auto state = cycle();
  EXPECT_EQ(state.measured_at, time_.now());
}

/// A soft robot with an arm in its sling; every command holds the start.
class SoftRobotTest : public SimulatedRobotTest {
 protected:
  robot::RobotState hold(double seconds, double stiffness_nm_rad) {
    robot::RobotCommand command{.q_rad = startAngles(), .compliance = {}};
    command.compliance.joint_stiffness_nm_rad.setConstant(7, stiffness_nm_rad);
    robot::RobotState state;
    for (double t = 0.0; t < seconds; t += 0.001) {
      time_.set(time_.now() + std::chrono::milliseconds(1));
      state = *soft_.read();
      EXPECT_TRUE(soft_.command(command));
    }
    return state;
  }
  [[nodiscard]] double sag(const robot::RobotState& state) const {
    const auto place = [&](const robot::Joints& q) {
      return Eigen::Vector3d(kinematics_.flange(q) * p_FE_F_);
    };
    return place(startAngles()).z() - place(state.q_rad).z();
  }

  Eigen::Vector3d p_FE_F_{0.0, 0.0, 0.135};
  robot::Kinematics kinematics_{arm_};
  SimulatedRobot soft_{arm_,
                       startAngles(),
                       time_,
                       {.seed = 5, .gives_way = true, .load = SlingArm{.weight_n = 20.0}, .p_FE_F = p_FE_F_}};
};

TEST_F(SoftRobotTest, SagsUnderTheArmByItsSpringsAndComesToRest) {
  const auto stiff = hold(2.0, 1000.0);
  const double little = sag(stiff);
  EXPECT_LT(stiff.v_rad_s.cwiseAbs().maxCoeff(), 1e-3);
  const auto soft = hold(3.0, 200.0);
  EXPECT_LT(soft.v_rad_s.cwiseAbs().maxCoeff(), 1e-3);
  EXPECT_GT(little, 0.001);
  EXPECT_GT(sag(soft), 4.0 * little) << "springs five times softer";
  soft_.load()->setEffort(1.0);
  EXPECT_LT(std::abs(sag(hold(3.0, 200.0))), 0.002) << "the patient carries his arm";
}

TEST_F(SoftRobotTest, TellsTheTorquesOfItsLoad) {
  const auto state = hold(2.0, 1000.0);
  robot::Joints spring = 1000.0 * (state.q_rad - startAngles());
  EXPECT_LT((state.external_torque_nm - spring).cwiseAbs().maxCoeff(), 0.6) << "springs in balance";
  soft_.load()->push({30.0, 0.0, 0.0});
  EXPECT_GT((hold(1.0, 1000.0).external_torque_nm - spring).norm(), 5.0);
}

TEST_F(SoftRobotTest, StandsStillWhenItIsHalted) {
  static_cast<void>(hold(1.0, 200.0));
  soft_.halt();
  const auto rest = soft_.read()->q_rad;
  soft_.load()->push({0.0, 0.0, -80.0});
  for (int i = 0; i < 100; ++i) {
    time_.set(time_.now() + kCycle);
    static_cast<void>(soft_.read());
  }
  EXPECT_LT((soft_.read()->q_rad - rest).cwiseAbs().maxCoeff(), 2e-4);
}

}  // namespace
}  // namespace mirrorarm::simulation
