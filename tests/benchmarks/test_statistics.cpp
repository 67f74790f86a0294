#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "benchmarks/parallel.h"
#include "benchmarks/statistics.h"

namespace mirrorarm::benchmarks {
namespace {

// Quantiles of chi-square from tables: 200 degrees 162.728 and 241.058; 30 degrees 16.791 and 46.979.
TEST(Statistics, BandOfChiSquareMeans) {
  const Interval wide = chiSquareMeanBand(3, 10);
  EXPECT_NEAR(wide.low, 1.6791, 2e-3);
  EXPECT_NEAR(wide.high, 4.6979, 2e-3);
  const Interval narrow = chiSquareMeanBand(2, 100);
  EXPECT_NEAR(narrow.low, 1.62728, 1e-3);
  EXPECT_NEAR(narrow.high, 2.41058, 1e-3);
}

// From tables of the Poisson distribution: one-sided 95 %.
TEST(Statistics, UpperLimitOfCounts) {
  EXPECT_NEAR(poissonUpperLimit(0), 2.9957, 1e-3);
  EXPECT_NEAR(poissonUpperLimit(1), 4.7439, 1e-3);
  EXPECT_NEAR(poissonUpperLimit(10), 16.962, 1e-2);
  EXPECT_NEAR(poissonUpperLimit(1000), 1053.6, 1.0);
}

TEST(Statistics, Quantiles) {
  EXPECT_EQ(quantile({3.0, 1.0, 2.0}, 0.5), 2.0);
  EXPECT_EQ(quantile({3.0, 1.0, 2.0}, 1.0), 3.0);
  EXPECT_TRUE(std::isnan(quantile({}, 0.5)));
}

TEST(Statistics, RootMeanSquareOverAxes) {
  RootMeanSquare rms;
  rms.addSquare(25.0, 2);
  rms.addSquare(0.0, 2);
  EXPECT_DOUBLE_EQ(rms.value(), 2.5);
  EXPECT_TRUE(std::isnan(RootMeanSquare().value()));
}

TEST(Parallel, EachTrialOnce) {
  std::vector<int> seen(1000, 0);
  forEachTrial(1000, [&] { return [&](int trial) { ++seen[static_cast<std::size_t>(trial)]; }; });
  EXPECT_EQ(std::accumulate(seen.begin(), seen.end(), 0), 1000);
  EXPECT_EQ(*std::ranges::min_element(seen), 1);
}

TEST(Parallel, FailuresComeOut) {
  const auto fail = [] { return [](int) { throw std::runtime_error("no"); }; };
  EXPECT_THROW(forEachTrial(10, fail), std::runtime_error);
}

}  // namespace
}  // namespace mirrorarm::benchmarks
