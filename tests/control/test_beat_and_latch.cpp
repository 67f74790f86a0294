#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "core/control/beat.h"
#include "core/control/stop_latch.h"

namespace mirrorarm::control {
namespace {

constexpr double kPeriod_s = 0.005;
constexpr TimePoint kStart{std::chrono::hours(1)};

TimePoint after(double seconds) { return kStart + toClock(Seconds(seconds)); }

}  // namespace

TEST(Beat, EvenCallsPassThrough) {
  Beat beat{Seconds(kPeriod_s)};
  for (int i = 0; i < 1000; ++i) {
    const TimePoint now = kStart + i * std::chrono::milliseconds(5);
    EXPECT_EQ(beat.next(now), now);
  }
}

TEST(Beat, UnevenCallsAreEvenedOut) {
  Beat beat{Seconds(kPeriod_s)};
  std::mt19937 random(2);
  std::uniform_real_distribution<double> late(0.0, 0.003);
  TimePoint last = beat.next(kStart);
  for (int i = 1; i < 2000; ++i) {
    const TimePoint next = beat.next(after(i * kPeriod_s + late(random)));
    EXPECT_NEAR(secondsBetween(last, next), kPeriod_s, 1e-4);
    EXPECT_NEAR(secondsBetween(next, after(i * kPeriod_s)), 0.0, 0.004);
    last = next;
  }
}

TEST(Beat, CatchesUpGentlyAfterAShortPauseAndJumpsAfterALongOne) {
  Beat beat{Seconds(kPeriod_s)};
  double t = 0.0;
  const auto behind = [&] {
    t += kPeriod_s;
    return secondsBetween(beat.next(after(t)), after(t));
  };
  for (int i = 0; i < 100; ++i) EXPECT_NEAR(behind(), 0.0, 1e-6);
  t += 0.02;
  EXPECT_NEAR(behind(), 0.02, 1e-4);
  for (int i = 0; i < 1000; ++i) EXPECT_LT(std::abs(behind()), 0.02);
  EXPECT_NEAR(behind(), 0.0, 1e-3);
  t += 0.2;
  EXPECT_NEAR(behind(), 0.0, 1e-6);
}

TEST(StopLatch, KeepsTheFirstReasonAndNoticesEveryChange) {
  StopLatch latch;
  const auto free = latch.value();
  EXPECT_EQ(free.reason, StopReason::kNone);
  latch.stop(StopReason::kTargetLost);
  latch.stop(StopReason::kOperator);
  EXPECT_EQ(latch.value().reason, StopReason::kTargetLost);
  EXPECT_TRUE(latch.reset(latch.value()));
  EXPECT_EQ(latch.value().reason, StopReason::kNone);
  EXPECT_FALSE(latch.value() == free);
}

TEST(StopLatch, AStopDuringAResetIsNotLost) {
  StopLatch latch;
  latch.stop(StopReason::kTargetLost);
  const auto seen = latch.value();
  latch.stop(StopReason::kOperator);
  EXPECT_FALSE(latch.reset(seen));
  EXPECT_EQ(latch.value().reason, StopReason::kTargetLost);
}

TEST(StopReason, EveryReasonHasItsOwnId) {
  std::vector<std::string_view> ids;
  for (int i = 0; i < kStopReasonCount; ++i) ids.push_back(id(static_cast<StopReason>(i)));
  EXPECT_EQ(std::count(ids.begin(), ids.end(), "unknown"), 0);
  std::sort(ids.begin(), ids.end());
  EXPECT_EQ(std::unique(ids.begin(), ids.end()), ids.end());
}

}  // namespace mirrorarm::control
