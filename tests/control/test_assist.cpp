#include <cmath>

#include "tests/common/no_heap.h"
#include "tests/control/servo_bench.h"

namespace mirrorarm::control {
namespace {

using robot::GivesWay;
using robot::Joints;
using testing::ServoBench;

constexpr Seconds kCycle{0.001};

AssistPlan adapting() {
  AssistPlan plan;
  plan.help.adapts = true;
  return plan;
}

/// An arm of 20 N in a sling on a spring: what the patient does not carry himself stretches the spring.
class Patient {
 public:
  explicit Patient(const AssistPlan& plan) : plan_(plan), level_(plan.help.level) {}

  /// `effort`: the share that he carries.
  void train(double effort, double seconds) {
    for (double t = 0.0; t < seconds; t += kCycle.count()) {
      const double stiffness_n_m = complianceAt(level_, plan_, 7).tool_stiffness[0];
      error_m_ += kCycle.count() / 0.3 * ((1.0 - effort) * 20.0 / stiffness_n_m - error_m_);
      const double next = assistAfter(level_, error_m_, plan_, kCycle);
      EXPECT_LE(std::abs(next - level_), plan_.max_rate_1_s * kCycle.count() + 1e-12);
      EXPECT_GE(next, 0.0);
      EXPECT_LE(next, 1.0);
      level_ = next;
    }
  }
  [[nodiscard]] double level() const { return level_; }
  [[nodiscard]] double error() const { return error_m_; }

 private:
  AssistPlan plan_;
  double level_;
  double error_m_ = 0.0;
};

}  // namespace

TEST(Assist, ThePatientWhoRecoversGetsLessHelp) {
  Patient patient(adapting());
  patient.train(0.0, 60.0);
  const double weak = patient.level();
  patient.train(0.5, 60.0);
  const double better = patient.level();
  patient.train(1.0, 60.0);
  EXPECT_GT(weak, 0.3);
  EXPECT_LT(better, 0.8 * weak);
  EXPECT_LT(patient.level(), 0.01) << "nothing is left to lean on";
}

TEST(Assist, ThePatientWhoRelaxesGetsMoreHelpAndIsNotCarriedForEver) {
  Patient patient(adapting());
  patient.train(1.0, 60.0);
  const double able = patient.level();
  patient.train(0.0, 60.0);
  EXPECT_GT(patient.level(), able + 0.3);
  EXPECT_LT(patient.level(), 0.95) << "forgetting leaves him something to do";
  EXPECT_GT(patient.error(), adapting().free_error_m);
}

TEST(Assist, LevelStaysWithinItsBoundsForAnyError) {
  const AssistPlan plan = adapting();
  for (const double level : {0.0, 0.5, 1.0})
    for (const double error : {0.0, 1e-3, 1.0, 1e9, std::nan(""), HUGE_VAL}) {
      const double next = assistAfter(level, error, plan, kCycle);
      EXPECT_GE(next, 0.0);
      EXPECT_LE(next, 1.0);
      EXPECT_LE(std::abs(next - level), plan.max_rate_1_s * kCycle.count() + 1e-12);
    }
  EXPECT_DOUBLE_EQ(assistAfter(0.4, std::nan(""), plan, kCycle), 0.4);
}

TEST(Assist, StiffnessLiesBetweenThePlansLeastAndMost) {
  const AssistPlan plan;
  const auto least = complianceAt(-1.0, plan, 7), most = complianceAt(2.0, plan, 7);
  EXPECT_EQ(least.joint_stiffness_nm_rad, Joints::Constant(7, plan.least.joint_nm_rad));
  EXPECT_EQ(most.joint_stiffness_nm_rad, Joints::Constant(7, plan.most.joint_nm_rad));
  EXPECT_DOUBLE_EQ(complianceAt(0.5, plan, 7).tool_stiffness[1],
                   0.5 * (plan.least.tool_n_m + plan.most.tool_n_m));
  EXPECT_DOUBLE_EQ(most.tool_stiffness[5], plan.most.tool_turn_nm_rad);
}

TEST(Assist, RobotThatDoesNotGiveWayIsSentNoSprings) {
  ServoBench bench;
  bench.run(0.1);
  EXPECT_EQ(bench.robot.compliance.joint_stiffness_nm_rad.size(), 0);
  EXPECT_DOUBLE_EQ(bench.state.assist.level, 1.0);
}

TEST(Assist, LevelIsForgottenWhileFollowingOnly) {
  AssistSettings settings;
  settings.plan = adapting();
  ServoBench bench({}, GivesWay::kAtTool, settings);
  bench.following = false;
  bench.cycle();
  const double before = bench.state.assist.level;
  bench.run(1.0);
  EXPECT_DOUBLE_EQ(bench.state.assist.level, before);
  bench.following = true;
  bench.run(2.0);
  EXPECT_NEAR(bench.state.assist.level, before * std::exp(-2.0 * settings.plan.forgetting_1_s), 0.01);
}

TEST(Assist, ChosenLevelIsReachedAtThePlansRateWhateverIsChosenMeanwhile) {
  ServoBench bench({}, GivesWay::kInJoints);
  const AssistPlan plan;
  double level = bench.state.assist.level;
  const auto follow = [&](double seconds) {
    for (double t = 0.0; t < seconds; t += kCycle.count()) {
      bench.cycle();
      EXPECT_LE(std::abs(bench.state.assist.level - level), plan.max_rate_1_s * kCycle.count() + 1e-12);
      level = bench.state.assist.level;
    }
  };
  bench.loop->setHelp({false, 0.2});
  follow(1.0);
  EXPECT_NEAR(level, 0.5, 0.002);
  EXPECT_NEAR(bench.robot.compliance.joint_stiffness_nm_rad[0],
              complianceAt(level, plan, 7).joint_stiffness_nm_rad[0], 1e-9);
  bench.loop->setHelp({true, 0.9});
  follow(0.5);
  EXPECT_NEAR(level, 0.5, 0.05) << "adapts from where it was";
  bench.loop->setHelp({false, 0.9});
  follow(2.0);
  EXPECT_DOUBLE_EQ(level, 0.9);
}

TEST(Assist, ChosenLevelStaysWithinItsBounds) {
  ServoBench bench({}, GivesWay::kAtTool);
  for (const auto& [chosen, level] : {std::pair{-3.0, 0.0}, {7.0, 1.0}, {0.4, 0.4}, {std::nan(""), 0.4}}) {
    bench.loop->setHelp({false, chosen});
    bench.run(3.0);
    EXPECT_DOUBLE_EQ(bench.state.assist.level, level) << chosen;
  }
}

TEST(Assist, StepThatHelpsDoesNotAllocate) {
  if (!::mirrorarm::testing::heapIsCounted) GTEST_SKIP() << "a sanitizer owns the heap";
  AssistSettings settings;
  settings.plan = adapting();
  ServoBench bench({}, GivesWay::kInJoints, settings);
  bench.robot.external_torque_nm = 3.0 * Joints::Ones(7);
  bench.enabling = EnablingPosition::kEnabled;
  bench.setOut();
  std::size_t calls = 0;
  for (int i = 0; i < 500; ++i) {
    if (i % 50 == 0) bench.loop->setHelp({i % 100 == 0, 0.002 * i});
    if (i == 300) bench.robot.external_torque_nm = 300.0 * Joints::Ones(7);
    calls += ::mirrorarm::testing::heapCallsIn([&] { bench.cycle(); });
  }
  EXPECT_EQ(bench.state.stop, StopReason::kForce);
  EXPECT_EQ(calls, 0U);
}

}  // namespace mirrorarm::control
