#include <cmath>

#include <gtest/gtest.h>

#include "core/simulation/exercise_motion.h"

namespace mirrorarm::simulation {
namespace {

const std::vector<MinimumJerkLeg> kLegs{{{0.1, 0.0, 0.05}, 0.3, 2.0, 0.5}, {{0.0, 0.0, 0.0}, 0.0, 1.5, 0.5}};

TEST(ExerciseMotion, ReachesItsWayPointsAndComesBack) {
  const auto X_BA = makeTransform(Eigen::Matrix3d::Identity(), {0.5, 0.4, 0.3});
  const ExerciseMotion motion(X_BA, kLegs);
  EXPECT_TRUE(motion.poseAt(0.0).isApprox(X_BA));
  const auto reached = motion.poseAt(2.2);
  EXPECT_NEAR((reached.translation() - X_BA.translation() - kLegs[0].displacement_m).norm(), 0.0, 1e-12);
  EXPECT_NEAR(angleBetween(reached, X_BA), 0.3, 1e-12);
  EXPECT_TRUE(motion.poseAt(4.5).isApprox(X_BA));
  EXPECT_TRUE(motion.poseAt(4.5 + 1.1).isApprox(motion.poseAt(1.1), 1e-9));
}

TEST(ExerciseMotion, HasTheSpeedOfMinimumJerk) {
  const ExerciseMotion motion(RigidTransform::Identity(), kLegs);
  constexpr double kStep = 1e-4;
  const double peak =
      (motion.poseAt(1.0 + kStep).translation() - motion.poseAt(1.0 - kStep).translation()).norm() /
      (2 * kStep);
  EXPECT_NEAR(peak, 1.875 * kLegs[0].displacement_m.norm() / 2.0, 1e-4);
  EXPECT_NEAR((motion.poseAt(kStep).translation()).norm() / kStep, 0.0, 1e-4);
}

TEST(ExerciseMotion, RestsWithoutLegs) {
  const ExerciseMotion motion(RigidTransform::Identity(), {});
  EXPECT_TRUE(motion.poseAt(12.3).isApprox(RigidTransform::Identity()));
}

TEST(ExerciseMotion, DiscsKeepTheirShapeAndLookOutwards) {
  const ExerciseMotion motion(makeTransform(Eigen::Matrix3d::Identity(), {0.5, 0.4, 0.3}), kLegs);
  std::vector<Disc> start(10), later(10);
  ASSERT_EQ(motion.discCount(), 10);
  motion.discsAt(0.0, start);
  motion.discsAt(1.3, later);
  for (std::size_t i = 0; i < 10; ++i) {
    EXPECT_NEAR(later[i].normal_B.norm(), 1.0, 1e-12);
    for (std::size_t k = 0; k < i; ++k)
      EXPECT_NEAR((later[i].p_B - later[k].p_B).norm(), (start[i].p_B - start[k].p_B).norm(), 1e-12);
  }
}

TEST(ExerciseMotion, NoTwoDistancesOfTheSleeveAreAlikeAroundOneDisc) {
  // A layout that maps onto itself would let the tracker swap markers.
  const auto& discs = sleeveDiscs();
  const auto profile = [&](std::size_t i) {
    std::vector<double> distances;
    for (const auto& other : discs) distances.push_back((other.p_B - discs[i].p_B).norm());
    std::sort(distances.begin(), distances.end());
    return distances;
  };
  for (std::size_t i = 0; i < discs.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      double difference = 0.0;
      for (std::size_t n = 0; n < discs.size(); ++n)
        difference = std::max(difference, std::abs(profile(i)[n] - profile(k)[n]));
      EXPECT_GT(difference, 0.005) << i << ' ' << k;
    }
}

}  // namespace
}  // namespace mirrorarm::simulation
