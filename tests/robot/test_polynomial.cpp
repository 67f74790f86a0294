#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "core/robot/polynomial.h"

namespace mirrorarm::robot {

TEST(Polynomial, QuinticMeetsBothEnds) {
  const EndState from{0.1, 0.2, -0.3}, to{0.5, -0.1, 0.4};
  constexpr double duration = 1.7;
  const Polynomial p = quinticBetween(from, to, duration);
  const Polynomial v = derivative(p), a = derivative(v);
  EXPECT_NEAR(valueAt(p, 0.0), from.q, 1e-12);
  EXPECT_NEAR(valueAt(v, 0.0), from.v, 1e-12);
  EXPECT_NEAR(valueAt(a, 0.0), from.a, 1e-12);
  EXPECT_NEAR(valueAt(p, duration), to.q, 1e-12);
  EXPECT_NEAR(valueAt(v, duration), to.v, 1e-12);
  EXPECT_NEAR(valueAt(a, duration), to.a, 1e-12);
}

TEST(Polynomial, RangesAreThoseOfDenseSamples) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  for (int round = 0; round < 300; ++round) {
    const double duration = 1.5 + any(random);
    const Polynomial p = quinticBetween({any(random), any(random), any(random)},
                                        {any(random), any(random), any(random)}, duration);
    const Polynomial curves[] = {p, derivative(p), derivative(derivative(p))};
    const MotionRanges ranges = rangesOf(p, duration);
    const Range found[] = {ranges.position, ranges.speed, ranges.acceleration};
    for (int k = 0; k < 3; ++k) {
      double least = 1e9, most = -1e9;
      for (int i = 0; i <= 2000; ++i) {
        const double value = valueAt(curves[k], duration * i / 2000.0);
        least = std::min(least, value);
        most = std::max(most, value);
      }
      ASSERT_NEAR(found[k].least, least, 1e-4 * (1.0 + most - least));
      ASSERT_NEAR(found[k].most, most, 1e-4 * (1.0 + most - least));
      ASSERT_LE(found[k].least, least + 1e-9);
      ASSERT_GE(found[k].most, most - 1e-9);
    }
  }
}

}  // namespace mirrorarm::robot
