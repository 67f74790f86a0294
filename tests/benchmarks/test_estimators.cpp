#include <gtest/gtest.h>

#include "benchmarks/vision/disc.h"
#include "benchmarks/vision/estimators.h"

namespace mirrorarm::benchmarks::vision {
namespace {

TEST(Estimators, EachFindsAPlainDisc) {
  TrialRandom random(7, 8, 9);
  for (int trial = 0; trial < 5; ++trial) {
    const Disc disc = randomDisc(14.0, 0.8, random);
    const auto image = exposed(lightOf(disc), 1.8, random);
    for (const auto& estimator : allEstimators()) {
      const auto answer = estimator->estimate(image.view(), disc.centre_px.array().round());
      ASSERT_TRUE(answer) << estimator->name();
      EXPECT_LT((answer->centre_px - disc.centre_px).norm(), 0.3) << estimator->name();
      EXPECT_EQ(answer->covariance_px2.has_value(), estimator->isOurs()) << estimator->name();
    }
  }
}

TEST(Estimators, NoneFindsADiscInNoise) {
  TrialRandom random(7, 8, 10);
  const auto image = exposed(Light(kDiscImage_px, kDiscImage_px, 12.0), 1.8, random);
  for (const auto& estimator : allEstimators()) {
    if (estimator->name() == "grey_centroid" || estimator->name() == "vpDot2") continue;  // they always do
    EXPECT_FALSE(estimator->estimate(image.view(), {40.0, 40.0})) << estimator->name();
  }
}

}  // namespace
}  // namespace mirrorarm::benchmarks::vision
