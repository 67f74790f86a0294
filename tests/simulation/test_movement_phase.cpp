#include <cmath>

#include <gtest/gtest.h>

#include "core/simulation/movement_phase.h"

namespace mirrorarm::simulation {
namespace {

TimePoint at(double seconds) { return TimePoint(toClock(Seconds(seconds))); }

TEST(MovementPhase, RestsUntilItIsSwitchedOn) {
  MovementPhase phase;
  EXPECT_EQ(phase.at(at(100.0)), 0.0);
  phase.set(at(10.0), true);
  EXPECT_EQ(phase.at(at(9.0)), 0.0);
  EXPECT_NEAR(phase.at(at(10.5)), 0.25, 1e-12);
  EXPECT_NEAR(phase.at(at(12.0)), 1.75, 1e-12);
}

TEST(MovementPhase, KeepsItsHistory) {
  MovementPhase phase;
  phase.set(at(1.0), true);
  phase.set(at(3.0), false);
  phase.set(at(3.2), true);
  const double before = phase.at(at(2.5));
  phase.set(at(7.0), false);
  EXPECT_EQ(phase.at(at(2.5)), before);
  EXPECT_NEAR(phase.at(at(20.0)), phase.at(at(7.5)), 1e-12);
}

TEST(MovementPhase, SpeedHasNoJumpsWhateverTheSwitches) {
  MovementPhase phase;
  for (const double t : {1.0, 1.1, 1.3, 2.0, 2.05, 2.6})
    phase.set(at(t), std::lround(10 * t) != 11 && std::lround(10 * t) != 20 && std::lround(10 * t) != 26);
  constexpr double kStep = 1e-3;
  double speed = 0.0;
  for (double t = 0.5; t < 4.0; t += kStep) {
    const double next = (phase.at(at(t + kStep)) - phase.at(at(t))) / kStep;
    EXPECT_LT(std::abs(next - speed), 3.1 * kStep) << t;  // a ramp of 0.5 s is at most 3 per second steep
    EXPECT_GE(next, -1e-9);
    speed = next;
  }
}

}  // namespace
}  // namespace mirrorarm::simulation
