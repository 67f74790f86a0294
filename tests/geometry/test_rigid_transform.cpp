#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "core/geometry/rigid_fit.h"
#include "core/geometry/rigid_transform.h"

using namespace mirrorarm;
using Eigen::Vector3d;

namespace {

RigidTransform turned(double angle, const Vector3d& axis, const Vector3d& shift = Vector3d::Zero()) {
  return makeTransform(Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis.normalized())), shift);
}

}  // namespace

TEST(RigidTransform, EqualRotationsPrintAlike) {
  const Eigen::Quaterniond q(-0.5, 0.5, -0.5, 0.5);
  const auto a = rotationOf(makeTransform(q, Vector3d::Zero()));
  const auto b = rotationOf(makeTransform(Eigen::Quaterniond(0.5, -0.5, 0.5, -0.5), Vector3d::Zero()));
  EXPECT_GE(a.w(), 0.0);
  EXPECT_LT((a.coeffs() - b.coeffs()).norm(), 1e-12);
}

TEST(RigidTransform, AQuaternionIsNormalised) {
  EXPECT_TRUE(isRigid(makeTransform(Eigen::Quaterniond(2.0, 0.0, 3.0, 1.0), Vector3d(1, 2, 3))));
}

TEST(RigidTransform, AngleAndRotationVectorAgree) {
  for (const double angle : {0.0, 1e-6, 0.3, 3.0, std::numbers::pi - 1e-7}) {
    const auto X = turned(angle, Vector3d(1, -2, 0.5));
    EXPECT_NEAR(angleBetween(RigidTransform::Identity(), X), angle, 1e-7);
    EXPECT_NEAR(rotationVector(X.linear()).norm(), angle, 1e-7);
  }
}

TEST(RigidTransform, InterpolatesAtEvenSpeed) {
  const auto from = turned(0.2, Vector3d::UnitY(), Vector3d(0, 0, 1));
  const auto to = turned(1.0, Vector3d::UnitY(), Vector3d(2, 0, 1));
  EXPECT_TRUE(interpolate(from, to, 0.0).isApprox(from, 1e-12));
  EXPECT_TRUE(interpolate(from, to, 1.0).isApprox(to, 1e-12));
  EXPECT_TRUE(
      interpolate(from, to, 0.25).isApprox(turned(0.4, Vector3d::UnitY(), Vector3d(0.5, 0, 1)), 1e-12));
}

TEST(RigidTransform, KnowsWhatIsNotRigid) {
  RigidTransform X = turned(0.5, Vector3d(1, 1, 1));
  EXPECT_TRUE(isRigid(X));
  X.linear() *= 1.01;
  EXPECT_FALSE(isRigid(X));
  X = RigidTransform::Identity();
  X.linear()(0, 0) = -1.0;
  EXPECT_FALSE(isRigid(X));
  X = RigidTransform::Identity();
  X.translation().y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(isRigid(X));
}

TEST(RigidFit, RmsIsTheRootOfTheMeanSquare) {
  const std::vector<Vector3d> x{Vector3d::Zero(), Vector3d::UnitX()};
  const std::vector<Vector3d> y{Vector3d(0, 3, 0), Vector3d(1, 0, 1)};
  EXPECT_NEAR(fitRms(RigidTransform::Identity(), x, y), std::sqrt(5.0), 1e-12);
}

TEST(RigidFit, OnePointGivesAShiftThatFits) {
  const std::vector<Vector3d> x{Vector3d(1, 0, 0)}, y{Vector3d(0, 2, 0)};
  const auto X = fitByKabsch(x, y);
  EXPECT_TRUE(isRigid(X));
  EXPECT_LT(fitRms(X, x, y), 1e-12);
}
