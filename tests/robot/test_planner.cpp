#include <gtest/gtest.h>

#include "core/robot/kinematics.h"
#include "core/robot/planner.h"
#include "tests/robot/arms.h"

namespace mirrorarm::robot {
namespace {

Planner plannerAround(std::span<const Obstacle> obstacles, const PlannerSettings& settings = {}) {
  return {testing::lbr(), {}, obstacles, settings};
}

/// Refuses contact only.
PlannerSettings touching() {
  PlannerSettings settings;
  settings.keep = kTouching;
  settings.reserve_m = 0.0;
  return settings;
}

Joints turned(double a1) {
  Joints q = testing::working();
  q[0] = a1;
  return q;
}

/// A thin wall where the flange passes on its way from turned(-0.5) to turned(0.5).
std::vector<Obstacle> wall(double height) {
  const Eigen::Vector3d flange = Kinematics(testing::lbr()).flange(turned(0.0)).translation();
  return {{makeTransform(Eigen::Quaterniond::Identity(), flange), {0.15, 0.01, height}}};
}

}  // namespace

TEST(Planner, KnowsWhenTheArmTouchesItself) {
  const Planner planner = plannerAround({}, touching());
  EXPECT_FALSE(planner.collides(Joints::Zero(7)));
  EXPECT_FALSE(planner.collides(testing::working()));
  Joints elbow_bent = Joints::Zero(7), wrist_bent = Joints::Zero(7), into_base = Joints::Zero(7);
  elbow_bent[3] = 2.09;
  EXPECT_FALSE(planner.collides(elbow_bent));
  wrist_bent[5] = 2.09;
  EXPECT_FALSE(planner.collides(wrist_bent));
  // Shoulder and elbow bent by 120 degrees in the same sense carry the wrist into the base column.
  into_base[1] = -2.09;
  into_base[3] = 2.09;
  EXPECT_TRUE(planner.collides(into_base));
}

TEST(Planner, OrdinaryPosturesOfEveryArmAreClear) {
  for (const char* name : {"lbr4plus", "iiwa7", "iiwa14", "ur5"}) {
    const ArmDescription arm = testing::arm(name);
    const Planner planner(arm, {}, {}, touching());
    EXPECT_FALSE(planner.collides(Joints::Zero(arm.jointCount()))) << name;
    if (arm.jointCount() != 7) continue;
    for (const int joint : {1, 3, 5})
      for (const double end : {-2.094, 2.094}) {
        Joints bent = Joints::Zero(7);
        bent[joint] = end;
        EXPECT_FALSE(planner.collides(bent)) << name << ' ' << joint;
      }
  }
}

TEST(Planner, AttachedShapesTouchTheUpperArm) {
  Joints folded = Joints::Zero(7);
  folded[3] = 2.09;
  folded[5] = -2.09;
  EXPECT_FALSE(plannerAround({}, touching()).collides(folded));
  const std::vector<Capsule> bar = {{7, Eigen::Vector3d::Zero(), {0.0, 0.0, 0.25}, 0.03}};
  const Planner with_bar(testing::lbr(), bar, {}, touching());
  EXPECT_TRUE(with_bar.collides(folded));
  EXPECT_FALSE(with_bar.collides(testing::working()));
}

TEST(Planner, ClearMotionIsStraight) {
  Planner planner = plannerAround({});
  const auto path = planner.plan(turned(-0.5), turned(0.5));
  ASSERT_TRUE(path);
  EXPECT_TRUE(path->direct);
  ASSERT_EQ(path->waypoints.size(), 1U);
  EXPECT_EQ(path->waypoints[0], turned(0.5));
}

TEST(Planner, GoesAroundAWallWithoutTouchingIt) {
  const auto obstacles = wall(0.2);
  Planner planner = plannerAround(obstacles);
  EXPECT_FALSE(planner.directIsClear(turned(-0.5), turned(0.5)));
  const auto path = planner.plan(turned(-0.5), turned(0.5));
  ASSERT_TRUE(path) << id(path.error().why);
  EXPECT_FALSE(path->direct);
  EXPECT_LE(path->waypoints.size(), 32U);
  EXPECT_EQ(path->waypoints.back(), turned(0.5));
  Joints last = turned(-0.5);
  double length = 0.0;
  for (const Joints& next : path->waypoints) {
    EXPECT_TRUE(planner.directIsClear(last, next));
    EXPECT_LE(next[0], 1.5);
    EXPECT_GE(next[0], -1.5);
    length += (next - last).norm();
    last = next;
  }
  EXPECT_LT(length, 4.0);  // the straight way is 1 long
}

TEST(Planner, SameQuestionSamePath) {
  const auto obstacles = wall(0.2);
  const auto one = plannerAround(obstacles).plan(turned(-0.5), turned(0.5));
  const auto other = plannerAround(obstacles).plan(turned(-0.5), turned(0.5));
  ASSERT_TRUE(one && other);
  ASSERT_EQ(one->waypoints.size(), other->waypoints.size());
  for (std::size_t i = 0; i < one->waypoints.size(); ++i) EXPECT_EQ(one->waypoints[i], other->waypoints[i]);
}

TEST(Planner, SaysWhyThereIsNoPath) {
  const auto obstacles = wall(0.2);
  Planner planner = plannerAround(obstacles);
  EXPECT_EQ(planner.plan(turned(0.0), turned(0.5)).error().why, PlanError::kStartBlocked);
  EXPECT_EQ(planner.plan(turned(0.5), turned(0.0)).error().why, PlanError::kGoalBlocked);
  EXPECT_EQ(planner.plan(turned(0.5), turned(3.1)).error().why, PlanError::kGoalBlocked);
}

TEST(Planner, NamesWhatStandsInTheWay) {
  auto obstacles = wall(0.2);
  obstacles[0].name = "shelf";
  Planner planner = plannerAround(obstacles);
  const auto refused = planner.plan(turned(0.5), turned(0.0));
  ASSERT_FALSE(refused);
  ASSERT_TRUE(refused.error().contact);
  EXPECT_EQ(describe(*refused.error().contact), "link meets box 'shelf'");
  EXPECT_FALSE(planner.contact(turned(0.5)));
  EXPECT_FALSE(planner.plan(turned(0.5), turned(3.1)).error().contact);
}

TEST(Planner, AHeadIsABall) {
  const Eigen::Vector3d below =
      Kinematics(testing::lbr()).flange(turned(0.0)) * Eigen::Vector3d(0.0, 0.0, 0.36);
  const std::vector<Capsule> sling = {{7, Eigen::Vector3d::Zero(), {0.0, 0.0, 0.1}, 0.06, ArmPart::kSling}};
  const auto contactAt = [&](double radius) {
    const std::vector<Obstacle> head = {ball(ObstacleKind::kHead, below, radius)};
    return Planner(testing::lbr(), sling, head, touching()).contact(turned(0.0));
  };
  EXPECT_FALSE(contactAt(0.19));
  const auto contact = contactAt(0.21);
  ASSERT_TRUE(contact);
  EXPECT_EQ(describe(*contact), "sling meets head");
}

TEST(Planner, KeepsTheGuardsDistancesAllTheWay) {
  const auto obstacles = wall(0.2);
  const auto path = plannerAround(obstacles).plan(turned(-0.5), turned(0.5));
  ASSERT_TRUE(path);
  const SafeDistances more{.self_m = 0.014, .obstacle_m = 0.024};  // 1 mm of the reserve for proven edges
  const CollisionWorld world(testing::lbr(), {}, obstacles, more);
  Joints last = turned(-0.5);
  for (const Joints& next : path->waypoints) {
    EXPECT_FALSE(world.firstContact(last, next, 0.001));
    last = next;
  }
}

// The guard lets the arm come to 20 mm; a plan keeps 25.
TEST(Planner, FindsTheWayOutOfANarrowPlaceAndIntoOne) {
  const Eigen::Vector3d flange = Kinematics(testing::lbr()).flange(turned(0.0)).translation();
  const std::vector<Capsule> ball_hand = {{7, {0.0, 0.0, 0.1}, {0.0, 0.0, 0.1}, 0.04, ArmPart::kSling}};
  const Eigen::Vector3d hand =
      Kinematics(testing::lbr()).flange(turned(0.0)) * Eigen::Vector3d(0.0, 0.0, 0.1);
  const Eigen::Vector3d out = (hand - flange).normalized();
  const auto plannerAt = [&](double gap_m) {
    const Eigen::Vector3d centre = hand + (gap_m + 0.04 + 0.05) * out;
    return Planner(testing::lbr(), ball_hand, std::vector<Obstacle>{ball(ObstacleKind::kBox, centre, 0.05)},
                   {});
  };
  Planner near = plannerAt(0.022), too_near = plannerAt(0.015), touching = plannerAt(-0.001);
  EXPECT_TRUE(near.plan(turned(0.0), turned(0.5)));
  EXPECT_TRUE(near.plan(turned(0.5), turned(0.0)));
  EXPECT_TRUE(too_near.plan(turned(0.0), turned(0.5))) << "out of it";
  EXPECT_EQ(too_near.plan(turned(0.5), turned(0.0)).error().why, PlanError::kGoalBlocked);
  EXPECT_EQ(touching.plan(turned(0.0), turned(0.5)).error().why, PlanError::kStartBlocked);
}

TEST(Planner, RefusesPathsThatMoveAJointTooFar) {
  const auto obstacles = wall(1.6);
  PlannerSettings narrow;
  narrow.max_joint_range_rad = 0.02;
  narrow.max_time = Seconds(2.0);
  const auto path = plannerAround(obstacles, narrow).plan(turned(-0.5), turned(0.5));
  ASSERT_FALSE(path);
  EXPECT_TRUE(path.error().why == PlanError::kJointRange || path.error().why == PlanError::kNoPath);
}

}  // namespace mirrorarm::robot
