#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "benchmarks/vision/information.h"

namespace mirrorarm::benchmarks::vision {
namespace {

Disc circle(double diameter_px) {
  Disc disc;
  disc.centre_px = {40.2, 39.7};
  disc.axes_px = 0.5 * diameter_px * Eigen::Matrix2d::Identity();
  return disc;
}

TEST(Information, FormulaOfACircle) {
  const double blur = std::sqrt(0.49 + 1.0 / 12.0);
  EXPECT_NEAR(centreBoundFormula(circle(10), 1.8),
              0.01 * std::sqrt(4.0 * blur / (std::sqrt(std::numbers::pi) * 10.0)), 1e-12);
}

TEST(Information, FormulaAgreesWithThePixels) {
  for (const double diameter_px : {7.0, 10.0, 24.0}) {
    const CentreBound bound = centreBound(circle(diameter_px), 1.8);
    EXPECT_NEAR(bound.centre_alone / centreBoundFormula(circle(diameter_px), 1.8), 1.0, 0.04) << diameter_px;
  }
}

TEST(Information, WhatIsUnknownCostsCertainty) {
  const CentreBound bound = centreBound(circle(10), 1.8);
  EXPECT_NEAR(bound.blurred_ellipse, bound.centre_alone, 0.01 * bound.centre_alone)
      << "a disc's symmetry parts its centre from its shape";
  EXPECT_GT(bound.with_ramp, 1.2 * bound.centre_alone) << "a ramp looks like a shift";
}

TEST(Information, GrowsWithTheNoise) {
  EXPECT_NEAR(centreBound(circle(10), 4.5).centre_alone, 2.5 * centreBound(circle(10), 1.8).centre_alone,
              1e-9);
}

}  // namespace
}  // namespace mirrorarm::benchmarks::vision
