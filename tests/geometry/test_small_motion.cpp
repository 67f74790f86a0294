#include <random>

#include <gtest/gtest.h>

#include "core/geometry/small_motion.h"

using namespace mirrorarm;
using Eigen::Vector3d;

namespace {

Vector3d randomVector(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return {normal(random), normal(random), normal(random)};
}

}  // namespace

TEST(SmallMotion, TheCrossMatrixMultipliesAsItsVector) {
  std::mt19937 random(1);
  const Vector3d v = randomVector(random), w = randomVector(random);
  EXPECT_LT((crossMatrix(v) * w - v.cross(w)).norm(), 1e-15);
}

TEST(SmallMotion, TurnByUndoesTheRotationVector) {
  std::mt19937 random(2);
  for (int i = 0; i < 100; ++i) {
    const Vector3d turn = 0.9 * randomVector(random).normalized();
    EXPECT_LT((rotationVector(turnBy(turn)) - turn).norm(), 1e-12);
  }
  EXPECT_TRUE(turnBy(Vector3d::Zero()).isIdentity(0.0));
}

TEST(SmallMotion, MotionAtIsTheDerivativeOfAMovedPoint) {
  std::mt19937 random(3);
  constexpr double kStep = 1e-6;
  for (int i = 0; i < 20; ++i) {
    SmallMotion motion;
    motion << randomVector(random), randomVector(random);
    const Vector3d p_T = randomVector(random);
    const Vector3d difference = (smallMotion(kStep * motion) * p_T - p_T) / kStep;
    EXPECT_LT((difference - motionAt(p_T) * motion).norm(), 1e-4);
  }
}

TEST(SmallMotion, AMovedPoseStaysRigidOverManySteps) {
  std::mt19937 random(4);
  RigidTransform X = RigidTransform::Identity();
  for (int i = 0; i < 10'000; ++i) {
    SmallMotion motion;
    motion << randomVector(random), randomVector(random);
    X = moved(X, 0.1 * motion);
  }
  EXPECT_TRUE(isRigid(X, 1e-12));
}
