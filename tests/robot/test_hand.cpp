#include <fstream>
#include <random>

#include <gtest/gtest.h>

#include "core/robot/hand.h"
#include "tests/common/scratch_folder.h"
#include "tests/robot/arms.h"
#include "tests/robot/mutations.h"

namespace mirrorarm::robot {
namespace {

const std::filesystem::path kShipped = std::filesystem::path(RESOURCES) / "robots/hand.yaml";

FromFile<Hand> readText(const std::string& text) {
  const test::ScratchFolder folder;
  return readHand(folder.holding("hand.yaml", text));
}

std::string refusalWith(const std::string& old, const std::string& other) {
  const auto read = readText(testing::withInstead(testing::textOf(kShipped), old, other));
  return read ? "accepted" : std::to_string(read.error().line) + ": " + read.error().reason;
}

}  // namespace

TEST(Hand, TheBenchsOneHasABarAndASling) {
  const auto hand = readHand(kShipped);
  ASSERT_TRUE(hand) << describe(hand.error());
  EXPECT_NEAR(hand->X_FE.translation().z(), 0.135, 1e-12);
  EXPECT_LT((hand->X_FC.linear() * Eigen::Vector3d::UnitX() + Eigen::Vector3d::UnitX()).norm(), 1e-12);
  const ArmDescription arm = testing::lbr();
  const auto shapes = attachedTo(arm, *hand);
  ASSERT_EQ(shapes.size(), 2U);
  EXPECT_EQ(shapes[0].part, ArmPart::kCameraBar);
  EXPECT_EQ(shapes[1].part, ArmPart::kSling);
  for (const Capsule& shape : shapes) EXPECT_EQ(shape.link, 7);
  // The bar lies behind both lenses.
  const RigidTransform X_CF = hand->X_FC.inverse();
  EXPECT_LT((X_CF * hand->shapes_F[0].a - Eigen::Vector3d(0.0, 0.0, -0.02)).norm(), 1e-8);
  EXPECT_LT((X_CF * hand->shapes_F[0].b - Eigen::Vector3d(0.12, 0.0, -0.02)).norm(), 1e-8);
}

TEST(Hand, ShapesFollowTheFlangeOnTheLastLink) {
  ArmDescription arm = testing::lbr();
  arm.X_last_F.translation().z() = 0.3;
  Hand hand;
  hand.shapes_F.push_back({0, {0.0, 0.0, 0.1}, {0.1, 0.0, 0.1}, 0.02, ArmPart::kSling});
  EXPECT_NEAR(attachedTo(arm, hand)[0].b.z(), 0.4, 1e-12);
}

TEST(Hand, RefusesWithLineAndReason) {
  EXPECT_EQ(describe(readHand("/nowhere/hand.yaml").error()), "/nowhere/hand.yaml: cannot be read");
  EXPECT_EQ(refusalWith("hand/1", "hand/2"),
            "1: format is 'mirrorarm/hand/2' where 'mirrorarm/hand/1' is read");
  EXPECT_EQ(refusalWith("radius_m: 0.025", "radius_m: 0"), "14: shapes[0].radius_m is not between 0 and 0.5");
  EXPECT_NE(refusalWith("radius_m: 0.025", "radius_m: nan"), "accepted");
  EXPECT_EQ(refusalWith("part: sling", "part: spoon"), "15: shapes[1].part is neither camera_bar nor sling");
  EXPECT_NE(refusalWith("to_m: [0, 0, 0.09]", "to_m: [0, 0, 90]"), "accepted");
  EXPECT_NE(refusalWith("rotation_xyzw: [0, 0, 0, 1]", "rotation_xyzw: [0, 0, 0, 0]"), "accepted");
  EXPECT_NE(refusalWith("flange_from_sling", "flange_from_slong"), "accepted");
}

TEST(Hand, SurvivesMutations) {
  testing::forMutationsOf(testing::textOf(kShipped), 500, [](const std::string& text) {
    const auto read = readText(text);
    if (!read) {
      EXPECT_FALSE(read.error().reason.empty());
    }
  });
}

}  // namespace mirrorarm::robot
