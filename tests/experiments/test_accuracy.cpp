#include <gtest/gtest.h>

#include "core/experiments/accuracy.h"

namespace mirrorarm::experiments {
namespace {

TEST(Accuracy, StatisticsOfKnownErrors) {
  const std::vector<AccuracyStation> stations = {{{1e-3, 0.0, 0.0}, {0.0, 0.0, 0.0}},
                                                 {{3e-3, 0.0, 4e-3}, {0.0, 0.0, 4e-3}}};
  const auto result = statisticsOf(stations);
  EXPECT_NEAR(result.bias_mm.x(), 2.0, 1e-12);
  EXPECT_NEAR(result.std_mm.x(), 1.0, 1e-12);
  EXPECT_NEAR(result.rms_mm, std::sqrt(5.0), 1e-12);
}

TEST(Accuracy, TheWholeChainBeatsThePaperSeveralTimes) {
  const auto result = measureAccuracy(RESOURCES, 7);
  ASSERT_TRUE(result) << result.error();
  EXPECT_LT(result->calibration.rig.stereo.rms_px, 0.03);
  EXPECT_LT(result->rig_bias.rms_mm, 0.06);
  EXPECT_EQ(result->tracked, result->frames);
  EXPECT_LT(result->chain.std_mm.maxCoeff(), 0.1);
  EXPECT_LT(result->chain.bias_mm.norm(), 0.2);
  EXPECT_LE(result->given.rms_mm, result->chain.rms_mm + 0.02);
}

TEST(Accuracy, MissingResourcesAreNamed) {
  const auto result = measureAccuracy("nowhere", 7);
  ASSERT_FALSE(result);
  EXPECT_NE(result.error().find("nowhere"), std::string::npos);
}

}  // namespace
}  // namespace mirrorarm::experiments
