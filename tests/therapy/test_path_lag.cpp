#include <random>

#include <gtest/gtest.h>

#include "core/therapy/path_lag.h"
#include "core/therapy/repetitions.h"

namespace mirrorarm::therapy {
namespace {

/// A sum of two swings, so that no shift but the true one fits.
Eigen::Vector3d curve(double time_s) {
  return 0.05 * Eigen::Vector3d(std::sin(1.7 * time_s), std::sin(1.1 * time_s + 0.4), std::cos(2.3 * time_s));
}

PathPair pathPair(double seconds, double rate_hz, double lag_s, double noise_m = 0.0, double jitter_s = 0.0) {
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0.0, 1.0);
  PathPair pair;
  for (int i = 0; i < static_cast<int>(seconds * rate_hz); ++i) {
    const double time = i / rate_hz + jitter_s * std::tanh(noise(random));
    const auto any = [&]() -> Eigen::Vector3d {
      return noise_m * Eigen::Vector3d(noise(random), noise(random), noise(random));
    };
    pair.time_s.push_back(time);
    pair.goal.push_back(curve(time) + any());
    pair.reached.push_back(curve(time - lag_s) + any());
  }
  return pair;
}

TEST(PathLag, FindsTheDelayWithinTheFrame) {
  for (const double lag_s : {-0.050, 0.0, 0.011, 0.137, 0.3187, 1.2}) {
    const auto found = lagOf(std::vector{pathPair(20.0, 24.0, lag_s)});
    ASSERT_TRUE(found) << lag_s;
    EXPECT_NEAR(*found, lag_s, 0.0005) << lag_s;
  }
}

TEST(PathLag, NoiseAndUnevenFramesCostMillisecondsAtMost) {
  for (const double lag_s : {0.020, 0.137, 0.3187}) {
    const auto found = lagOf(std::vector{pathPair(20.0, 24.0, lag_s, 0.0003, 0.004)});
    ASSERT_TRUE(found) << lag_s;
    EXPECT_NEAR(*found, lag_s, 0.003) << lag_s;
  }
}

TEST(PathLag, IsUnknownWithoutMovementOrTime) {
  auto still = pathPair(20.0, 24.0, 0.1);
  for (auto& point : still.goal) point = Eigen::Vector3d(0.1, 0.2, 0.3);
  EXPECT_FALSE(lagOf(std::vector{still}));
  EXPECT_FALSE(lagOf(std::vector{pathPair(1.0, 24.0, 0.1)}));
  EXPECT_FALSE(lagOf({}));
}

TEST(PathLag, IsUnknownBeyondTheRange) { EXPECT_FALSE(lagOf(std::vector{pathPair(20.0, 24.0, 1.7)})); }

TEST(PathLag, PointsLieOnTheStraightLineBetweenNeighbours) {
  const std::vector<double> times{0.0, 1.0, 3.0};
  const std::vector<Eigen::Vector3d> path{{0, 0, 0}, {1, 0, 0}, {1, 4, 0}};
  EXPECT_TRUE(pointAt(times, path, 2.0).isApprox(Eigen::Vector3d(1, 2, 0)));
  EXPECT_TRUE(pointAt(times, path, -1.0).isApprox(path.front()));
  EXPECT_TRUE(pointAt(times, path, 9.0).isApprox(path.back()));
}

TEST(Repetitions, CountOutAndBackOnly) {
  const std::vector<double> twice{0, 50, 100, 40, 0, 60, 95, 20, 0, 60, 90};
  EXPECT_EQ(countRepetitions(twice, 20), 2);
  EXPECT_EQ(countRepetitions(twice, 101), 0);
  EXPECT_EQ(countRepetitions({}, 20), 0);
}

TEST(Repetitions, TremorAtTheTurningPointIsNotAMovement) {
  const std::vector<double> trembling{0, 50, 69, 72, 68, 74, 66, 100, 60, 75, 31, 35, 29, 33, 28, 0};
  EXPECT_EQ(countRepetitions(trembling, 20), 1);
}

}  // namespace
}  // namespace mirrorarm::therapy
