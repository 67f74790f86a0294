#include <set>

#include <gtest/gtest.h>

#include "core/therapy/exercise.h"

namespace mirrorarm::therapy {
namespace {

TEST(Exercise, TheCatalogueIsFoundByName) {
  std::set<std::string> ids;
  for (const auto& exercise : exercises()) ids.insert(exercise.id);
  EXPECT_EQ(ids, (std::set<std::string>{"reach", "lift", "side", "circle", "turn"}));
  EXPECT_EQ(exerciseOf("lift")->id, "lift");
  EXPECT_FALSE(exerciseOf("dance"));
}

TEST(Exercise, EndsWhereItBegan) {
  for (const auto& exercise : exercises()) {
    ASSERT_FALSE(exercise.legs.empty());
    EXPECT_TRUE(exercise.legs.back().displacement_m.isZero()) << exercise.id;
    EXPECT_EQ(exercise.legs.back().forearm_turn_rad, 0.0) << exercise.id;
  }
}

// Minimum jerk peaks at 1.875 times the mean speed.
TEST(Exercise, StaysBelowWhatTheRobotCanFollow) {
  for (const auto& exercise : exercises()) {
    Exercise::Leg before;
    for (const auto& leg : exercise.legs) {
      EXPECT_LE(1.875 * (leg.displacement_m - before.displacement_m).norm() / leg.duration_s, 0.14)
          << exercise.id;
      EXPECT_LE(1.875 * std::abs(leg.forearm_turn_rad - before.forearm_turn_rad) / leg.duration_s, 0.24)
          << exercise.id;
      before = leg;
    }
  }
}

}  // namespace
}  // namespace mirrorarm::therapy
