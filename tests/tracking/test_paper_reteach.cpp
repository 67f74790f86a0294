#include <gtest/gtest.h>

#include "core/tracking/paper_reteach.h"
#include "tests/tracking/world.h"

using namespace mirrorarm;
using namespace mirrorarm::tracking;
using namespace mirrorarm::tracking::test;

TEST(PaperReteach, TakesUpMarkersThatSkinHasMoved) {
  const Target old = forearm();
  Noise noise(51);
  int adapted_rightly = 0;
  constexpr int kTrials = 50;
  for (int trial = 0; trial < kTrials; ++trial) {
    Target moved = old;
    for (auto& p : moved.markers_T) p += noise.gaussian(0.004);
    const RigidTransform X_CT = noise.pose();
    const auto scene = look(moved.markers_T, X_CT, 9, 1, noise);
    const auto adapted = paperReteach(old, cloudOf(scene), X_CT * noise.nudge(0.03, 0.003), {});
    ASSERT_TRUE(adapted) << trial;
    ASSERT_EQ(adapted->markers_T.size(), old.markers_T.size());
    std::vector<double> apart;
    for (std::size_t i = 0; i < 10; ++i)
      apart.push_back(std::abs((adapted->markers_T[i] - adapted->markers_T[(i + 1) % 10]).norm() -
                               (moved.markers_T[i] - moved.markers_T[(i + 1) % 10]).norm()));
    std::sort(apart.begin(), apart.end());
    // One marker was hidden, so its two distances may be the old ones.
    if (apart[7] < 0.002) ++adapted_rightly;
  }
  EXPECT_GE(adapted_rightly, kTrials * 9 / 10);
}

TEST(PaperReteach, NeedsALessonWhenTooFewMarkersAreThere) {
  const Target old = forearm();
  Noise noise(52);
  const RigidTransform X_CT = noise.pose();
  EXPECT_FALSE(paperReteach(old, cloudOf(look(old.markers_T, X_CT, 4, 0, noise)), X_CT, {}));
  EXPECT_FALSE(paperReteach(old, {}, X_CT, {}));
}
