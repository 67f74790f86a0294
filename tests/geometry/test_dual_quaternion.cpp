#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "core/geometry/dual_quaternion.h"
#include "core/geometry/rigid_fit.h"

using namespace mirrorarm;
using Eigen::Vector3d;

namespace {

struct Pairs {
  std::vector<Vector3d> x, y;
};

class DualQuaternion : public testing::Test {
 protected:
  Vector3d gaussian(double sigma) {
    std::normal_distribution<double> d(0.0, sigma);
    return {d(rng_), d(rng_), d(rng_)};
  }
  RigidTransform pose() {
    std::normal_distribution<double> d(0.0, 1.0);
    const Eigen::Quaterniond q(d(rng_), d(rng_), d(rng_), d(rng_));
    return makeTransform(q, gaussian(0.5));
  }
  Pairs pairs(const RigidTransform& X, std::size_t count, double noise) {
    Pairs pairs;
    for (std::size_t i = 0; i < count; ++i) {
      pairs.x.push_back(gaussian(0.1));
      pairs.y.push_back(X * pairs.x.back() + gaussian(noise));
    }
    return pairs;
  }

  std::mt19937 rng_{7};
};

}  // namespace

TEST_F(DualQuaternion, IsTheLeastSquaresPoseOfKabsch) {
  std::uniform_int_distribution<std::size_t> count(3, 20);
  for (int trial = 0; trial < 1000; ++trial) {
    const Pairs p = pairs(pose(), count(rng_), 0.002);
    const auto dual = fitByDualQuaternion(p.x, p.y, std::vector<double>(p.x.size(), 1.0));
    const auto kabsch = fitByKabsch(p.x, p.y);
    ASSERT_TRUE(isRigid(dual));
    ASSERT_LT((dual.matrix() - kabsch.matrix()).norm(), 1e-9) << trial;
  }
}

// Flat clouds, thin ones and nearly regular rings, near the origin and far from it: eigenvalues lie close.
TEST_F(DualQuaternion, IsThePoseOfKabschOnPlanarThinAndNearlySymmetricClouds) {
  const Vector3d extents[] = {{0.1, 0.1, 1e-4}, {0.1, 0.1, 0.0}, {0.1, 0.01, 0.001}, {0.1, 0.005, 0.005}};
  for (int trial = 0; trial < 4000; ++trial) {
    const RigidTransform X = pose();
    const int count = 4 + trial % 16;
    Pairs p;
    for (int i = 0; i < count; ++i) {
      const double turn = 2.0 * std::numbers::pi * i / count;
      const Vector3d ring(0.05 * std::cos(turn), 0.05 * std::sin(turn), 0.03 * (i % 2));
      p.x.push_back(trial % 5 == 4 ? Vector3d(ring + gaussian(1e-5))
                                   : Vector3d(gaussian(1.0).cwiseProduct(extents[trial % 5])));
      p.y.push_back(X * p.x.back() + gaussian(1.5e-4));
    }
    const auto dual = fitByDualQuaternion(p.x, p.y, std::vector<double>(p.x.size(), 1.0));
    ASSERT_LT((dual.matrix() - fitByKabsch(p.x, p.y).matrix()).norm(), 1e-9) << trial;
  }
}

TEST_F(DualQuaternion, FindsThePoseThatMadeThePoints) {
  for (int trial = 0; trial < 100; ++trial) {
    const RigidTransform X = pose();
    const Pairs p = pairs(X, 4, 0.0);
    EXPECT_LT((fitByDualQuaternion(p.x, p.y, std::vector<double>(4, 2.5)).matrix() - X.matrix()).norm(),
              1e-9);
  }
}

TEST_F(DualQuaternion, HalfTurnsAreNoSpecialCase) {
  for (int axis = 0; axis < 3; ++axis) {
    const RigidTransform X =
        makeTransform(Eigen::Quaterniond(Eigen::AngleAxisd(std::numbers::pi, Vector3d::Unit(axis))),
                      Vector3d(0.1, 0.2, 0.3));
    const Pairs p = pairs(X, 6, 0.0);
    EXPECT_LT((fitByDualQuaternion(p.x, p.y, std::vector<double>(6, 1.0)).matrix() - X.matrix()).norm(),
              1e-9);
  }
}

TEST_F(DualQuaternion, MirroredPointsStillGiveARotation) {
  Pairs p = pairs(RigidTransform::Identity(), 8, 0.0);
  for (auto& y : p.y) y.x() = -y.x();
  const auto X = fitByDualQuaternion(p.x, p.y, std::vector<double>(8, 1.0));
  EXPECT_TRUE(isRigid(X));
  EXPECT_LE(fitRms(X, p.x, p.y), fitRms(fitByKabsch(p.x, p.y), p.x, p.y) + 1e-9);
}

TEST_F(DualQuaternion, AWeightCountsLikeThatManyPairs) {
  Pairs p = pairs(pose(), 6, 0.01);
  std::vector<double> weights(6, 1.0);
  weights[2] = 3.0;
  const auto weighted = fitByDualQuaternion(p.x, p.y, weights);
  for (int copy = 0; copy < 2; ++copy) {
    p.x.push_back(p.x[2]);
    p.y.push_back(p.y[2]);
  }
  EXPECT_LT((weighted.matrix() - fitByKabsch(p.x, p.y).matrix()).norm(), 1e-9);
}

TEST_F(DualQuaternion, SoftPairsPullLikeTheirSum) {
  const Pairs p = pairs(pose(), 5, 0.01);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  Eigen::MatrixXd weights(5, 5);
  Pairs all;
  std::vector<double> flat;
  for (int j = 0; j < 5; ++j)
    for (int k = 0; k < 5; ++k) {
      weights(j, k) = share(rng_);
      all.x.push_back(p.x[static_cast<std::size_t>(j)]);
      all.y.push_back(p.y[static_cast<std::size_t>(k)]);
      flat.push_back(weights(j, k));
    }
  EXPECT_LT(
      (fitByDualQuaternion(p.x, p.y, weights).matrix() - fitByDualQuaternion(all.x, all.y, flat).matrix())
          .norm(),
      1e-9);
}

TEST_F(DualQuaternion, PointsOnALineOrOnASpotGiveSomePoseThatFits) {
  std::vector<Vector3d> x, y;
  for (int i = 0; i < 4; ++i) {
    x.emplace_back(0.1 * i, 0.0, 0.0);
    y.emplace_back(0.0, 0.1 * i, 1.0);
  }
  const auto line = fitByDualQuaternion(x, y, std::vector<double>(4, 1.0));
  EXPECT_TRUE(isRigid(line));
  EXPECT_LT(fitRms(line, x, y), 1e-9);
  const std::vector<Vector3d> spot(3, Vector3d(1, 2, 3)), other(3, Vector3d(3, 2, 1));
  const auto stacked = fitByDualQuaternion(spot, other, std::vector<double>(3, 1.0));
  EXPECT_TRUE(isRigid(stacked));
  EXPECT_LT(fitRms(stacked, spot, other), 1e-9);
}
