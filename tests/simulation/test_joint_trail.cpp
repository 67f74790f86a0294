#include <atomic>
#include <thread>

#include <gtest/gtest.h>

#include "core/simulation/joint_trail.h"

namespace mirrorarm::simulation {
namespace {

TimePoint at_ms(double time_ms) { return TimePoint(toClock(Seconds(1e-3 * time_ms))); }

robot::Joints both(double angle_rad) { return robot::Joints::Constant(2, angle_rad); }

TEST(JointTrail, InterpolatesAndHoldsAtItsEnds) {
  JointTrail trail(at_ms(10.0), both(0.1));
  EXPECT_EQ(trail.at(at_ms(0.0)), both(0.1));
  EXPECT_EQ(trail.at(at_ms(99.0)), both(0.1));
  trail.add(at_ms(20.0), both(0.3));
  EXPECT_TRUE(trail.at(at_ms(15.0)).isApprox(both(0.2), 1e-12));
  EXPECT_EQ(trail.at(at_ms(21.0)), both(0.3));
}

TEST(JointTrail, PassesOverWhatIsNotLater) {
  JointTrail trail(at_ms(10.0), both(0.1));
  trail.add(at_ms(10.0), both(7.0));
  trail.add(at_ms(5.0), both(7.0));
  EXPECT_EQ(trail.at(at_ms(10.0)), both(0.1));
}

TEST(JointTrail, ForgetsTheOldest) {
  JointTrail trail(at_ms(0.0), both(0.0));
  for (int i = 1; i < 20'000; ++i) trail.add(at_ms(i), both(i));
  EXPECT_EQ(trail.at(at_ms(0.0)), both(20'000 - 4096));
  for (const double time_ms : {15'904.5, 17'000.25, 19'998.75})
    EXPECT_NEAR(trail.at(at_ms(time_ms))[1], time_ms, 1e-6);
}

TEST(JointTrail, IsWholeForWhoeverLooksWhileItGrows) {
  JointTrail trail(at_ms(0.0), both(0.0));
  std::atomic<int> newest{0};
  const std::jthread writer([&] {
    for (int i = 1; i <= 200'000; ++i) {
      trail.add(at_ms(i), both(i));
      newest.store(i, std::memory_order_release);
    }
  });
  for (int seen = 0; seen < 200'000;) {
    seen = newest.load(std::memory_order_acquire);
    const double wanted_ms = seen - 0.5;
    const robot::Joints q = trail.at(at_ms(wanted_ms));
    EXPECT_EQ(q[0], q[1]);
    EXPECT_GE(q[0], std::max(0.0, wanted_ms - 1e-6));  // more where it has been forgotten meanwhile
  }
}

}  // namespace
}  // namespace mirrorarm::simulation
