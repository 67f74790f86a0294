#include <set>
#include <tuple>

#include <gtest/gtest.h>

#include "core/tracking/distance_index.h"
#include "tests/tracking/world.h"

using namespace mirrorarm::tracking;
using namespace mirrorarm::tracking::test;

TEST(DistanceIndex, GivesEveryDistanceWithinTheWidthAndNoOther) {
  Noise noise(1);
  std::vector<std::vector<Vector3d>> targets(5);
  for (auto& markers : targets)
    for (int i = 0; i < 12; ++i) markers.push_back(noise.stranger({0, 0, 0}));
  DistanceIndex index;
  index.build(targets);
  for (int trial = 0; trial < 500; ++trial) {
    const double distance_m = noise.uniform(0.0, 0.6), width_m = noise.uniform(0.0, 0.01);
    std::set<std::tuple<int, int, int>> expected, given;
    for (int t = 0; t < 5; ++t)
      for (int a = 0; a < 12; ++a)
        for (int b = a + 1; b < 12; ++b) {
          const auto& markers = targets[static_cast<std::size_t>(t)];
          const double length =
              (markers[static_cast<std::size_t>(a)] - markers[static_cast<std::size_t>(b)]).norm();
          if (std::abs(length - distance_m) <= width_m) expected.emplace(t, a, b);
        }
    index.forEachNear(distance_m, width_m, [&](const DistanceIndex::Entry& entry) {
      EXPECT_TRUE(given.emplace(entry.target, entry.a, entry.b).second);
    });
    EXPECT_EQ(given, expected) << trial;
  }
}

TEST(DistanceIndex, HoldsNothingWithoutPairs) {
  DistanceIndex index;
  const auto fail = [](const DistanceIndex::Entry&) { FAIL(); };
  index.forEachNear(0.1, 1.0, fail);
  index.build(std::vector<std::vector<Vector3d>>{{}, {Vector3d(1, 2, 3)}});
  index.forEachNear(0.0, 1.0, fail);
  EXPECT_EQ(index.longest(), 0.0);
}

TEST(DistanceIndex, MarkersOnOneSpotAreAtDistanceZero) {
  DistanceIndex index;
  index.build(std::vector<std::vector<Vector3d>>{{Vector3d(1, 2, 3), Vector3d(1, 2, 3)}});
  int given = 0;
  index.forEachNear(0.0005, 0.001, [&](const DistanceIndex::Entry&) { ++given; });
  EXPECT_EQ(given, 1);
}
