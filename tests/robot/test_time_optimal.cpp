#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "core/robot/time_optimal.h"

namespace mirrorarm::robot {
namespace {

constexpr AxisLimits kLimits{-0.24, 0.24, 0.8, 40.0};

EndState endOf(EndState state, const AxisMotion& motion) {
  for (const JerkPiece& piece : motion.pieces) state = after(state, piece);
  return state;
}

/// The largest excess over the limits along the way, sampled, in units of the limit.
double worstShare(EndState state, const AxisMotion& motion, const AxisLimits& limits) {
  double worst = 0.0;
  for (const JerkPiece& piece : motion.pieces) {
    constexpr int samples = 20;
    for (int i = 0; i <= samples; ++i) {
      const EndState s = after(state, {piece.duration_s * i / samples, piece.jerk});
      worst = std::max({worst, s.v / limits.most_speed, s.v / limits.least_speed,
                        std::abs(s.a) / limits.acceleration, std::abs(piece.jerk) / limits.jerk});
    }
    state = after(state, piece);
  }
  return worst;
}

/// A state from which the speed limits can still be kept.
EndState randomStart(std::mt19937& random, const AxisLimits& limits) {
  std::uniform_real_distribution<double> place(-0.3, 0.3), share(-1.0, 1.0);
  for (;;) {
    const EndState start{place(random), limits.most_speed * share(random),
                         limits.acceleration * share(random)};
    const double coasting = coastingSpeed(start, limits.jerk);
    if (coasting < limits.most_speed && coasting > limits.least_speed && start.v > limits.least_speed)
      return start;
  }
}

}  // namespace

TEST(SpeedChange, ArrivesWithoutAcceleration) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> speed(-0.24, 0.24);
  for (int i = 0; i < 20'000; ++i) {
    const EndState start = randomStart(random, kLimits);
    const double wanted = speed(random);
    EndState state = start;
    for (const JerkPiece& piece : changeSpeed(start, wanted, kLimits)) {
      EXPECT_GE(piece.duration_s, 0.0);
      state = after(state, piece);
      EXPECT_LE(std::abs(state.a), kLimits.acceleration + 1e-9);
    }
    ASSERT_NEAR(state.v, wanted, 1e-9);
    ASSERT_NEAR(state.a, 0.0, 1e-9);
  }
}

TEST(SpeedChange, LeadsAnAccelerationBackThatIsTooLarge) {
  EndState state{0.0, 0.0, 2.0};
  const SpeedChange change = changeSpeed(state, 0.2, kLimits);
  for (const JerkPiece& piece : change) state = after(state, piece);
  EXPECT_NEAR(state.v, 0.2, 1e-9);
  EXPECT_NEAR(state.a, 0.0, 1e-9);
}

TEST(TimeOptimal, ReachesRestWithinTheLimits) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> place(-0.3, 0.3);
  for (const AxisLimits& limits :
       {kLimits, AxisLimits{-0.40, 0.08, 0.5, 40.0}, AxisLimits{-0.01, 0.47, 0.8, 8.0}})
    for (int i = 0; i < 20'000; ++i) {
      const EndState start = randomStart(random, limits);
      const double goal = i % 2 == 0 ? place(random) : start.q + 0.01 * place(random);
      const AxisMotion motion = toRestAt(goal, start, limits);
      const EndState end = endOf(start, motion);
      ASSERT_NEAR(end.q, goal, 1e-9) << i;
      ASSERT_NEAR(end.v, 0.0, 1e-9) << i;
      ASSERT_NEAR(end.a, 0.0, 1e-9) << i;
      ASSERT_LE(worstShare(start, motion, limits), 1.0 + 1e-6) << i;
    }
}

TEST(TimeOptimal, FromRestItTakesTheLeastTime) {
  const auto duration = [](double way) { return toRestAt(way, {}, kLimits).duration(); };
  const double j = kLimits.jerk, a = kLimits.acceleration, v = kLimits.most_speed;
  EXPECT_NEAR(duration(0.0), 0.0, 1e-12);
  // Never at full acceleration; then never at full speed; then with all seven pieces.
  EXPECT_NEAR(duration(1e-5), 4.0 * std::cbrt(1e-5 / (2.0 * j)), 1e-7);
  const double ramp = a / j;
  EXPECT_NEAR(duration(0.01), ramp + std::sqrt(ramp * ramp + 4.0 * 0.01 / a), 1e-7);
  EXPECT_NEAR(duration(0.3), 0.3 / v + v / a + a / j, 1e-9);
  EXPECT_NEAR(duration(-0.3), duration(0.3), 1e-9);
}

TEST(TimeOptimal, GoingOnAMoreOftenPlannedMotionCostsHardlyAnyTime) {
  const double whole = toRestAt(0.05, {}, kLimits).duration();
  EndState state{};
  double t = 0.0;
  const double step = 0.01;
  for (; t < 2.0 && (std::abs(state.q - 0.05) > 1e-6 || std::abs(state.v) > 1e-5); t += step) {
    double left = step;
    for (const JerkPiece& piece : toRestAt(0.05, state, kLimits).pieces) {
      const double lasts = std::min(left, piece.duration_s);
      state = after(state, {lasts, piece.jerk});
      left -= lasts;
    }
  }
  EXPECT_LT(t, whole + 2.0 * step);
}

TEST(TimeOptimal, AFasterStartThanAllowedIsLedBack) {
  const EndState start{0.0, 0.5, 0.0};
  const AxisMotion motion = toRestAt(0.4, start, kLimits);
  const EndState end = endOf(start, motion);
  EXPECT_NEAR(end.q, 0.4, 1e-9);
  EXPECT_NEAR(end.v, 0.0, 1e-9);
}

}  // namespace mirrorarm::robot
