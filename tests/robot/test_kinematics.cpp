#include <numbers>
#include <span>

#include <gtest/gtest.h>

#include "core/robot/kinematics.h"
#include "tests/common/no_heap.h"
#include "tests/robot/arms.h"

namespace mirrorarm::robot {
namespace {

constexpr double kRight = std::numbers::pi / 2.0;

/// A row of the Denavit-Hartenberg tables [m, rad].
struct Row {
  double d, a, alpha;
};

RigidTransform throughTable(std::span<const Row> rows, const Joints& q) {
  using Eigen::AngleAxisd, Eigen::Translation3d, Eigen::Vector3d;
  RigidTransform X = RigidTransform::Identity();
  for (std::size_t i = 0; i < rows.size(); ++i)
    X = X * AngleAxisd(q[static_cast<Eigen::Index>(i)], Vector3d::UnitZ()) * Translation3d(0, 0, rows[i].d) *
        Translation3d(rows[i].a, 0, 0) * AngleAxisd(rows[i].alpha, Vector3d::UnitX());
  return X;
}

const std::array<Row, 7> kLbr = {{{0.3105, 0, kRight},
                                  {0, 0, -kRight},
                                  {0.400, 0, -kRight},
                                  {0, 0, kRight},
                                  {0.390, 0, kRight},
                                  {0, 0, -kRight},
                                  {0.078, 0, 0}}};
const std::array<Row, 6> kUr5 = {{{0.089159, 0, kRight},
                                  {0, -0.425, 0},
                                  {0, -0.39225, 0},
                                  {0.10915, 0, kRight},
                                  {0.09465, 0, -kRight},
                                  {0.0823, 0, 0}}};

void expectSame(const RigidTransform& X, const RigidTransform& Y, double tolerance) {
  EXPECT_LT((X.translation() - Y.translation()).norm(), tolerance);
  EXPECT_LT((X.linear() - Y.linear()).norm(), tolerance);
}

}  // namespace

TEST(Kinematics, FlangeAgreesWithTheDenavitHartenbergTables) {
  std::mt19937 random(3);
  const ArmDescription lbr = testing::lbr(), ur5 = testing::arm("ur5");
  const Kinematics of_lbr(lbr), of_ur5(ur5);
  for (int i = 0; i < 200; ++i) {
    const Joints q = testing::randomJoints(lbr, random, 1.0), p = testing::randomJoints(ur5, random, 1.0);
    expectSame(of_lbr.flange(q), throughTable(kLbr, q), 1e-9);
    expectSame(of_ur5.flange(p), throughTable(kUr5, p), 1e-9);
  }
}

TEST(Kinematics, UprightArmIsAsHighAsItsParts) {
  const Kinematics kinematics(testing::lbr());
  EXPECT_NEAR(kinematics.flange(Joints::Zero(7)).translation().z(), 0.3105 + 0.400 + 0.390 + 0.078, 1e-12);
  expectSame(kinematics.link(Joints::Zero(7), 0), RigidTransform::Identity(), 1e-12);
}

TEST(Kinematics, LinksStandWhereTheJointsCarryThem) {
  const ArmDescription lbr = testing::lbr();
  const Kinematics kinematics(lbr);
  std::mt19937 random(4);
  const Joints q = testing::randomJoints(lbr, random, 1.0);
  RigidTransform X = RigidTransform::Identity();
  for (int i = 0; i < lbr.jointCount(); ++i) {
    const auto& joint = lbr.joints[static_cast<std::size_t>(i)];
    X = X * joint.X_parent * Eigen::AngleAxisd(q[i], joint.axis);
    expectSame(kinematics.link(q, i + 1), X, 1e-9);
  }
  expectSame(kinematics.flange(q), X * lbr.X_last_F, 1e-9);
}

TEST(Kinematics, JacobianIsTheDerivativeOfTheFlange) {
  const ArmDescription lbr = testing::lbr();
  const Kinematics kinematics(lbr);
  std::mt19937 random(5);
  constexpr double step = 1e-6;
  for (int round = 0; round < 20; ++round) {
    const Joints q = testing::randomJoints(lbr, random, 0.9);
    const Jacobian J = kinematics.jacobian(q);
    for (int i = 0; i < lbr.jointCount(); ++i) {
      Joints less = q, more = q;
      less[i] -= step;
      more[i] += step;
      const RigidTransform X = kinematics.flange(less), Y = kinematics.flange(more);
      EXPECT_LT((J.col(i).head<3>() - (Y.translation() - X.translation()) / (2 * step)).norm(), 1e-6);
      const Eigen::Vector3d turn = rotationVector(Y.linear() * X.linear().transpose());
      EXPECT_LT((J.col(i).tail<3>() - turn / (2 * step)).norm(), 1e-6);
    }
  }
}

TEST(Kinematics, InverseFindsThousandReachablePosesFromNearby) {
  const ArmDescription lbr = testing::lbr();
  const Kinematics kinematics(lbr);
  std::mt19937 random(6);
  std::uniform_real_distribution<double> nearby(-0.2, 0.2);
  int found = 0;
  for (int i = 0; i < 1000; ++i) {
    const Joints truth = testing::randomJoints(lbr, random, 0.9);
    Joints seed = truth;
    for (double& angle : seed) angle += nearby(random);
    const RigidTransform X_BF = kinematics.flange(truth);
    const auto q = kinematics.inverse(X_BF, seed);
    if (!q) continue;
    ++found;
    ASSERT_LE((kinematics.flange(*q).translation() - X_BF.translation()).norm(), 1e-4);
    ASSERT_LE(angleBetween(kinematics.flange(*q), X_BF), 1.0001e-4);
    for (int j = 0; j < 7; ++j) {
      ASSERT_GE((*q)[j], lbr.joints[static_cast<std::size_t>(j)].lower_rad);
      ASSERT_LE((*q)[j], lbr.joints[static_cast<std::size_t>(j)].upper_rad);
    }
  }
  EXPECT_GE(found, 990);
}

TEST(Kinematics, SmallStepsOfTheGoalGiveSmallStepsOfTheJoints) {
  const Kinematics kinematics(testing::lbr());
  Joints q = testing::working();
  RigidTransform X_BF = kinematics.flange(q);
  for (int i = 0; i < 100; ++i) {
    X_BF.translation().y() += 0.001;
    const auto next = kinematics.inverse(X_BF, q);
    ASSERT_TRUE(next);
    EXPECT_LT((*next - q).cwiseAbs().maxCoeff(), 0.02);
    q = *next;
  }
}

TEST(Kinematics, InverseRefusesWhatCannotBeReached) {
  const Kinematics kinematics(testing::lbr());
  RigidTransform far = kinematics.flange(testing::working());
  far.translation() = Eigen::Vector3d(2.0, 0.0, 0.5);
  EXPECT_FALSE(kinematics.inverse(far, testing::working()));
  far.translation().x() = std::nan("");
  EXPECT_FALSE(kinematics.inverse(far, testing::working()));
}

TEST(Kinematics, ForwardDoesNotAllocate) {
  if (!::mirrorarm::testing::heapIsCounted) GTEST_SKIP() << "a sanitizer owns the heap";
  const Kinematics kinematics(testing::lbr());
  const Joints q = testing::working();
  double sum = 0.0;
  const auto calls = ::mirrorarm::testing::heapCallsIn([&] {
    for (int i = 0; i < 10; ++i) {
      sum += kinematics.flange(q).translation().x();
      sum += kinematics.link(q, 4).translation().x();
      sum += kinematics.jacobian(q)(0, 0);
    }
  });
  EXPECT_EQ(calls, 0U) << sum;
}

TEST(NoHeap, CountsWhatIsTaken) {
  if (!::mirrorarm::testing::heapIsCounted) GTEST_SKIP() << "a sanitizer owns the heap";
  const auto calls = ::mirrorarm::testing::heapCallsIn([] {
    double* volatile place = new double(1.0);
    delete place;
  });
  EXPECT_EQ(calls, 1U);
}

}  // namespace mirrorarm::robot
