#include <gtest/gtest.h>

#include "core/robot/hand.h"
#include "core/robot/planner.h"
#include "core/robot/surroundings.h"
#include "tests/common/scratch_folder.h"
#include "tests/robot/arms.h"
#include "tests/robot/mutations.h"

namespace mirrorarm::robot {
namespace {

const std::filesystem::path kRobots = std::filesystem::path(RESOURCES) / "robots";

FromFile<std::vector<Obstacle>> readText(const std::string& text) {
  const test::ScratchFolder folder;
  return readSurroundings(folder.holding("surroundings.yaml", text));
}

std::string refusalWith(const std::string& old, const std::string& other) {
  const auto read =
      readText(testing::withInstead(testing::textOf(kRobots / "surroundings.yaml"), old, other));
  return read ? "accepted" : std::to_string(read.error().line) + ": " + read.error().reason;
}

}  // namespace

TEST(Surroundings, TheBenchHasATableAndAHead) {
  const auto all = readSurroundings(kRobots / "surroundings.yaml");
  ASSERT_TRUE(all) << describe(all.error());
  ASSERT_EQ(all->size(), 2U);
  EXPECT_EQ((*all)[0].kind, ObstacleKind::kTable);
  EXPECT_EQ((*all)[1].kind, ObstacleKind::kHead);
  EXPECT_EQ((*all)[1].name, "patient");
  EXPECT_TRUE((*all)[1].size_m.isZero());
  EXPECT_NEAR((*all)[1].round_m, 0.2, 1e-12);
}

TEST(Surroundings, TheBenchsWorkIsClearAndTheTableIsNamed) {
  const ArmDescription arm = testing::lbr();
  const auto attached = attachedTo(arm, *readHand(kRobots / "hand.yaml"));
  const Planner planner(arm, attached, *readSurroundings(kRobots / "surroundings.yaml"), {});
  Joints bench(7);
  bench << 0.0, -0.48, 0.0, 1.45, 0.0, -1.21, 0.0;
  EXPECT_FALSE(planner.contact(bench));
  Joints low = bench;
  low[1] = -1.3;
  const auto contact = planner.contact(low);
  ASSERT_TRUE(contact);
  EXPECT_EQ(contact->obstacle, ObstacleKind::kTable);
}

TEST(Surroundings, RefusesWithLineAndReason) {
  EXPECT_EQ(refusalWith("kind: head", "kind: foot"),
            "8: obstacles[1].kind is neither box nor table nor head");
  EXPECT_EQ(refusalWith("radius_m: 0.2", "radius_m: -0.2"),
            "11: obstacles[1].radius_m is not a length up to 20 m");
  EXPECT_EQ(refusalWith("name: patient", "name: table"), "9: obstacles[1].name is there twice");
  EXPECT_NE(refusalWith("radius_m: 0.2", "radius_m: inf"), "accepted");
  EXPECT_NE(refusalWith("radius_m: 0.2", "size_m: [0, 1, 1]"), "accepted");
  EXPECT_NE(refusalWith("radius_m: 0.2", "size_m: [1, 1, 1, 1]"), "accepted");
  EXPECT_NE(refusalWith("    radius_m: 0.2\n", ""), "accepted");
  EXPECT_NE(refusalWith("radius_m: 0.2", "radius_m: 0.2\n    round_m: 0.1"), "accepted");
  EXPECT_NE(refusalWith("centre_m: [1.2,", "centre_m: [1200,"), "accepted");
  EXPECT_NE(refusalWith("kind: head", "colour: red\n    kind: head"), "accepted");
  EXPECT_EQ(refusalWith("radius_m: 0.2", "size_m: [0.3, 0.3, 0.3]\n    round_m: 0.1"), "accepted");
  EXPECT_EQ(refusalWith("radius_m: 0.2", "size_m: [0.3, 0.3, 0.3]\n    rotation_xyzw: [0, 0, 0.6, 0.8]"),
            "accepted");
}

TEST(Surroundings, SurvivesMutations) {
  testing::forMutationsOf(testing::textOf(kRobots / "surroundings.yaml"), 500, [](const std::string& text) {
    const auto read = readText(text);
    if (!read) {
      EXPECT_FALSE(read.error().reason.empty());
      return;
    }
    for (const Obstacle& obstacle : *read) EXPECT_TRUE(isRigid(obstacle.X_BO));
  });
}

}  // namespace mirrorarm::robot
