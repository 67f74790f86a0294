#include <numbers>

#include <gtest/gtest.h>

#include "core/robot/kinematics.h"
#include "core/robot/srs_postures.h"
#include "tests/common/no_heap.h"
#include "tests/robot/arms.h"

namespace mirrorarm::robot {
namespace {

constexpr double kPi = std::numbers::pi;

double misfit(const RigidTransform& X, const RigidTransform& Y) {
  return (X.matrix() - Y.matrix()).cwiseAbs().maxCoeff();
}

/// By how much angles differ, whole turns aside.
double difference(const Joints& one, const Joints& other) {
  double largest = 0.0;
  for (Eigen::Index i = 0; i < one.size(); ++i)
    largest = std::max(largest, std::abs(std::remainder(one[i] - other[i], 2.0 * kPi)));
  return largest;
}

class SrsArms : public ::testing::TestWithParam<const char*> {
 protected:
  ArmDescription arm_ = testing::arm(GetParam());
  SrsArm srs_ = *srsArm(arm_);
  Kinematics kinematics_{arm_};
  std::mt19937 random_{11};
};

}  // namespace

TEST_P(SrsArms, EveryBranchAtEveryArmAngleReachesThePose) {
  std::uniform_real_distribution<double> turn(-kPi, kPi);
  for (int i = 0; i < 2000; ++i) {
    const RigidTransform X_BF = kinematics_.flange(testing::randomJoints(arm_, random_, 1.0));
    const auto postures = SrsPostures::at(srs_, X_BF);
    ASSERT_TRUE(postures);
    for (const Joints& q : postures->branches(turn(random_)))
      ASSERT_LE(misfit(kinematics_.flange(q), X_BF), 1e-9) << q.transpose();
  }
}

TEST_P(SrsArms, BranchAndArmAngleOfAPostureGiveItBack) {
  for (int i = 0; i < 2000; ++i) {
    const Joints q = testing::randomJoints(arm_, random_, 1.0);
    const auto postures = SrsPostures::at(srs_, kinematics_.flange(q));
    ASSERT_TRUE(postures);
    const SrsWrist wrist = srsWrist(srs_, q);
    ASSERT_LE(misfit(wrist.X_UW, srs_.X_UB * kinematics_.flange(q) * srs_.X_FW), 1e-12);
    double nearest = 10.0;
    for (const Joints& p : postures->branches(wrist.arm_angle)) nearest = std::min(nearest, difference(p, q));
    ASSERT_LE(nearest, 1e-6) << q.transpose();
  }
}

TEST_P(SrsArms, BranchesDifferByTheSignsOfTheBendingJoints) {
  const Joints q = testing::randomJoints(arm_, random_, 0.8);
  const auto postures = SrsPostures::at(srs_, kinematics_.flange(q));
  ASSERT_TRUE(postures);
  const auto all = postures->branches(0.4);
  for (std::size_t b = 0; b < all.size(); ++b)
    for (std::size_t bit = 0; bit < 3; ++bit) {
      const auto middle = static_cast<Eigen::Index>(2 * bit + 1);
      EXPECT_EQ(all[b][middle] * srs_.sign[2 * bit + 1] < 0.0, (b >> bit & 1) == 1);
    }
}

TEST_P(SrsArms, RatesAreTheDerivativesByTheArmAngle) {
  constexpr double step = 1e-6;
  std::uniform_real_distribution<double> turn(-kPi, kPi);
  for (int i = 0; i < 200; ++i) {
    const auto postures =
        SrsPostures::at(srs_, kinematics_.flange(testing::randomJoints(arm_, random_, 0.8)));
    ASSERT_TRUE(postures);
    const double psi = turn(random_);
    for (int branch = 0; branch < kSrsBranches; ++branch) {
      const Joints q = postures->posture(psi, branch);
      if (std::min(std::abs(std::sin(q[1])), std::abs(std::sin(q[5]))) < 0.05) continue;
      const Joints change =
          (postures->posture(psi + step, branch) - postures->posture(psi - step, branch)) / (2.0 * step);
      ASSERT_LE(difference(postures->rates(q), change), 1e-4);
    }
  }
}

TEST_P(SrsArms, StretchedAndAlignedPosturesAreFoundToo) {
  for (const auto& [q2, q4, q6] : std::initializer_list<std::array<double, 3>>{{0, 0, 0},
                                                                               {0.5, 0, 0.7},
                                                                               {0, 0.9, 0.7},
                                                                               {0.5, 0.9, 0},
                                                                               {0, 0.9, 0},
                                                                               {1e-9, 1e-8, 1e-9},
                                                                               {0, 1e-6, 0}}) {
    const Joints q = (Joints(7) << 0.3, q2, -0.4, q4, 0.2, q6, 0.6).finished();
    const RigidTransform X_BF = kinematics_.flange(q);
    const auto postures = SrsPostures::at(srs_, X_BF);
    ASSERT_TRUE(postures);
    for (const Joints& p : postures->branches(srsWrist(srs_, q).arm_angle))
      EXPECT_LE(misfit(kinematics_.flange(p), X_BF), 1e-9) << q.transpose();
  }
}

TEST_P(SrsArms, OutOfReachIsNothing) {
  RigidTransform X_BF = kinematics_.flange(Joints::Zero(7));
  X_BF.translation() += 1e-6 * Eigen::Vector3d::UnitZ();
  EXPECT_FALSE(SrsPostures::at(srs_, X_BF));
  X_BF.translation().x() = std::nan("");
  EXPECT_FALSE(SrsPostures::at(srs_, X_BF));
}

TEST_P(SrsArms, NothingIsTakenFromTheHeap) {
  if (!::mirrorarm::testing::heapIsCounted) GTEST_SKIP() << "a sanitizer owns the heap";
  const RigidTransform X_BF = kinematics_.flange(testing::randomJoints(arm_, random_, 0.8));
  double sum = 0.0;
  EXPECT_EQ(::mirrorarm::testing::heapCallsIn([&] {
              const auto postures = SrsPostures::at(srs_, X_BF);
              for (const Joints& q : postures->branches(0.2)) sum += q.sum() + postures->rates(q).sum();
            }),
            0U)
      << sum;
}

INSTANTIATE_TEST_SUITE_P(Robots, SrsArms, ::testing::Values("lbr4plus", "iiwa7", "iiwa14"));

}  // namespace mirrorarm::robot
