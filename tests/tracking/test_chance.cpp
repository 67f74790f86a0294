#include <gtest/gtest.h>

#include "core/tracking/chance.h"
#include "core/tracking/constellation_search.h"
#include "tests/tracking/world.h"

using namespace mirrorarm::tracking;
using namespace mirrorarm::tracking::test;

TEST(Chance, MoreMarkersAreEverLessLikely) {
  const Crowd crowd{.markers = 10, .points = 40, .pair_rate = 0.012, .gate_rate = 1e-4};
  for (int matched = 3; matched < 10; ++matched)
    EXPECT_LT(expectedChanceFits(crowd, matched + 1), 0.01 * expectedChanceFits(crowd, matched));
  EXPECT_EQ(expectedChanceFits(crowd, 11), 0.0);
  EXPECT_EQ(expectedChanceFits({.markers = 10, .points = 3, .pair_rate = 0.1, .gate_rate = 1.0}, 4), 0.0);
}

TEST(Chance, TrianglesAreCountedOnce) {
  EXPECT_NEAR(expectedChanceFits({.markers = 3, .points = 3, .pair_rate = 0.1, .gate_rate = 0.0}, 3),
              6.0 * 0.001, 1e-12);
}

TEST(Chance, RateOfDistancesInABallIsAsCounted) {
  Noise noise(1);
  int near = 0, all = 0;
  while (all < 200'000) {
    const Vector3d a = noise.stranger({0, 0, 0}), b = noise.stranger({0, 0, 0});
    if (a.norm() > 0.15 || b.norm() > 0.15) continue;
    ++all;
    if (std::abs((a - b).norm() - 0.1) <= 0.002) ++near;
  }
  EXPECT_NEAR(static_cast<double>(near) / all, pairRateInBall(0.1, 0.002, 0.15), 0.001);
  EXPECT_EQ(pairRateInBall(0.4, 0.002, 0.15), 0.0);
  EXPECT_EQ(pairRateInBall(0.1, 0.002, 0.0), 1.0);
}

// Wide gates, so that there is something to count.
TEST(Chance, IsWhatIsCountedWithinAFactorOfThree) {
  const ConstellationSettings settings{.tolerance_m = 0.001, .max_chance = 1e9};
  const auto markers_T = forearm().markers_T;
  ConstellationSearch search(settings);
  search.setTargets(std::vector<std::span<const Vector3d>>{markers_T});
  Noise noise(2);
  constexpr int kFrames = 3000;
  int counted = 0;
  double expected = 0.0;
  for (int frame = 0; frame < kFrames; ++frame) {
    std::vector<CloudPoint> cloud;
    for (int i = 0; i < 70; ++i)
      cloud.push_back(
          {noise.stranger({0, 0, 0.5}), kSensorNoise_m * kSensorNoise_m * Eigen::Matrix3d::Identity(), {}});
    const auto& best = search.run(cloud)[0].best;
    if (best.matched != 4) continue;
    ++counted;
    expected += best.chance;
  }
  ASSERT_GT(counted, 15);
  const double rate = static_cast<double>(counted) / kFrames, mean = expected / counted;
  EXPECT_LT(rate, 3.0 * mean);
  EXPECT_GT(rate, mean / 3.0);
}
