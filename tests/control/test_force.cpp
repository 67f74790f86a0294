#include <cmath>
#include <random>

#include "core/control/force_estimate.h"
#include "tests/control/servo_bench.h"

namespace mirrorarm::control {
namespace {

using robot::Joints;
using testing::ServoBench;

constexpr Seconds kCycle{0.001};

struct Arm {
  robot::Kinematics kinematics{robot::testing::lbr()};
  Joints q = robot::testing::working();
  Eigen::Vector3d p_FE_F{0.0, 0.0, 0.135};

  [[nodiscard]] robot::Jacobian J() const {
    return jacobianAt(kinematics.flange(q).linear() * p_FE_F, kinematics.jacobian(q));
  }
  /// What the joints feel of a force at the sling.
  [[nodiscard]] Joints torqueOf(const Eigen::Vector3d& force_B) const {
    return J().topRows<3>().transpose() * force_B;
  }
};

}  // namespace

TEST(ForceEstimate, JacobianOfThePointIsItsDerivative) {
  const Arm arm;
  const auto place = [&](const Joints& q) { return Eigen::Vector3d(arm.kinematics.flange(q) * arm.p_FE_F); };
  for (int j = 0; j < 7; ++j) {
    const Joints step = 1e-6 * Joints::Unit(7, j);
    const Eigen::Vector3d slope = (place(arm.q + step) - place(arm.q - step)) / 2e-6;
    EXPECT_LT((slope - arm.J().block<3, 1>(0, j)).norm(), 1e-7);
  }
}

TEST(ForceEstimate, FindsTheForceAtTheSling) {
  const Arm arm;
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0.0, 0.1);  // Nm
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3d force = 40.0 * Eigen::Vector3d::Random();
    Joints torque = arm.torqueOf(force);
    for (double& one : torque) one += noise(random);
    const auto wrench = wrenchOf(torque, arm.J());
    EXPECT_LT((wrench.head<3>() - force).norm(), 0.05 * force.norm() + 2.0);
  }
}

TEST(ForceEstimate, StaysFiniteWhereThePostureIsStretched) {
  Arm arm;
  arm.q.setZero();
  const auto wrench = wrenchOf(Joints::Ones(7), arm.J());
  EXPECT_TRUE(wrench.allFinite());
  EXPECT_LT(wrench.norm(), 1e3);
}

TEST(ForceLimits, EveryRegionHasLimitsThatTransientContactsMayNotUndercut) {
  for (int i = 0; i < kBodyRegionCount; ++i) {
    const auto region = static_cast<BodyRegion>(i);
    const auto limits = limitsOf(region);
    EXPECT_GT(limits.quasi_static_n, 0.0) << id(region);
    EXPECT_GE(limits.transient_n, limits.quasi_static_n) << id(region);
    EXPECT_LE(limits.transient_n, 2.0 * limits.quasi_static_n) << id(region);
  }
  EXPECT_EQ(limitsOf(BodyRegion::kFace).transient_n, 65.0);
}

TEST(ForceWatch, GrowsFromWarningToStop) {
  ForceWatch watch({.region = BodyRegion::kForearm, .share = 0.5});  // 80 N that last, 160 N at once
  const auto lasting = [&](double newton) {
    for (int i = 0; i < 3000; ++i) static_cast<void>(watch.update({0.0, 0.0, -newton}, kCycle));
    return watch.reading().level;
  };
  EXPECT_EQ(lasting(40.0), ForceLevel::kCalm);
  EXPECT_EQ(lasting(50.0), ForceLevel::kWarning);
  EXPECT_EQ(lasting(70.0), ForceLevel::kSoften);
  EXPECT_EQ(lasting(81.0), ForceLevel::kTooMuch);
  EXPECT_NEAR(watch.reading().force_B_n.z(), -81.0, 0.1);
}

TEST(ForceWatch, ShortPushIsBorneAndALongOneIsNot) {
  const auto levelAfter = [](double newton, int cycles) {
    ForceWatch watch({.region = BodyRegion::kForearm, .share = 1.0});
    ForceLevel worst = ForceLevel::kCalm;
    for (int i = 0; i < cycles; ++i) worst = std::max(worst, watch.update({newton, 0.0, 0.0}, kCycle).level);
    return worst;
  };
  EXPECT_LT(levelAfter(250.0, 100), ForceLevel::kTooMuch);
  EXPECT_EQ(levelAfter(250.0, 500), ForceLevel::kTooMuch);
  EXPECT_EQ(levelAfter(400.0, 50), ForceLevel::kTooMuch) << "beyond the transient limit";
  EXPECT_EQ(levelAfter(std::nan(""), 1), ForceLevel::kTooMuch);
}

TEST(ForceAtTheRobot, StopsItAndSoftensItsSprings) {
  const Arm arm;
  AssistSettings assist;
  assist.p_FE_F = arm.p_FE_F;
  ServoBench bench({}, robot::GivesWay::kInJoints, assist);
  bench.speedUp();
  EXPECT_NEAR(bench.robot.compliance.joint_stiffness_nm_rad[0], assist.plan.most.joint_nm_rad, 1e-9);
  bench.robot.external_torque_nm = arm.torqueOf({0.0, 0.0, -70.0});
  bench.run(1.0);
  EXPECT_EQ(bench.state.assist.force.level, ForceLevel::kSoften);
  EXPECT_EQ(bench.state.stop, StopReason::kNone);
  EXPECT_LT(bench.robot.compliance.joint_stiffness_nm_rad[0], 0.9 * assist.plan.most.joint_nm_rad);
  bench.robot.external_torque_nm = arm.torqueOf({0.0, 0.0, -170.0});
  const int cycles = bench.cyclesToStop();
  EXPECT_GT(cycles, 0);
  EXPECT_LT(cycles, 100);
  EXPECT_EQ(bench.state.stop, StopReason::kForce);
  bench.run(3.0);
  EXPECT_NEAR(bench.robot.compliance.joint_stiffness_nm_rad[0], assist.plan.least.joint_nm_rad, 1e-9)
      << "who is caught must be let go";
}

}  // namespace mirrorarm::control
