#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/collision_object.h>
#include <gtest/gtest.h>

#include "core/robot/collision.h"
#include "core/robot/hand.h"
#include "core/robot/kinematics.h"
#include "core/robot/surroundings.h"
#include "tests/robot/arms.h"

namespace mirrorarm::robot {
namespace {

const std::filesystem::path kRobots = std::filesystem::path(RESOURCES) / "robots";

/// The same question answered by FCL.
class Judge {
 public:
  Judge(const ArmDescription& arm, std::span<const Capsule> attached, std::span<const Obstacle> obstacles)
      : kinematics_(arm), shapes_(arm.shapes) {
    shapes_.insert(shapes_.end(), attached.begin(), attached.end());
    for (const Obstacle& obstacle : obstacles) obstacles_.push_back(objectOf(obstacle));
  }

  [[nodiscard]] bool collides(const Joints& q) const {
    std::vector<fcl::CollisionObjectd> placed;
    for (const Capsule& shape : shapes_) placed.push_back(objectOf(kinematics_.link(q, shape.link), shape));
    for (std::size_t i = 0; i < placed.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j)
        if (std::abs(shapes_[i].link - shapes_[j].link) > 1 && touch(placed[i], placed[j])) return true;
      for (const auto& obstacle : obstacles_)
        if (shapes_[i].link > 0 && touch(placed[i], obstacle)) return true;
    }
    return false;
  }

 private:
  static bool touch(const fcl::CollisionObjectd& one, const fcl::CollisionObjectd& other) {
    fcl::CollisionResultd result;
    return fcl::collide(&one, &other, fcl::CollisionRequestd(), result) > 0;
  }

  static fcl::CollisionObjectd objectOf(const RigidTransform& X_BL, const Capsule& shape) {
    const Eigen::Vector3d axis = shape.b - shape.a;
    const RigidTransform X_LS = makeTransform(
        Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), axis), 0.5 * (shape.a + shape.b));
    if (axis.norm() < 1e-9)
      return {std::make_shared<fcl::Sphered>(shape.radius_m), RigidTransform(X_BL * X_LS)};
    return {std::make_shared<fcl::Capsuled>(shape.radius_m, axis.norm()), RigidTransform(X_BL * X_LS)};
  }

  static fcl::CollisionObjectd objectOf(const Obstacle& obstacle) {
    if (obstacle.size_m.isZero()) return {std::make_shared<fcl::Sphered>(obstacle.round_m), obstacle.X_BO};
    return {std::make_shared<fcl::Boxd>(obstacle.size_m), obstacle.X_BO};
  }

  Kinematics kinematics_;
  std::vector<Capsule> shapes_;
  std::vector<fcl::CollisionObjectd> obstacles_;
};

class Collisions : public ::testing::Test {
 protected:
  Collisions() {
    const Eigen::Quaterniond turned(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1.0, 2.0, 0.3).normalized()));
    obstacles_.push_back(
        {makeTransform(turned, {0.4, 0.3, 0.5}), {0.2, 0.3, 0.1}, ObstacleKind::kBox, "crate"});
  }

  ArmDescription arm_ = testing::lbr();
  std::vector<Capsule> attached_ = attachedTo(arm_, *readHand(kRobots / "hand.yaml"));
  std::vector<Obstacle> obstacles_ = *readSurroundings(kRobots / "surroundings.yaml");
  std::mt19937 random_{8};
};

}  // namespace

TEST_F(Collisions, AgreeWithFclInRandomPostures) {
  const CollisionWorld world(arm_, attached_, obstacles_, kTouching);
  const Judge judge(arm_, attached_, obstacles_);
  int blocked = 0, differ = 0;
  for (int i = 0; i < 4000; ++i) {
    const Joints q = testing::randomJoints(arm_, random_, 1.0);
    const bool collides = world.collides(q);
    if (collides) ++blocked;
    if (collides != judge.collides(q)) ++differ;
  }
  EXPECT_GT(blocked, 400);
  EXPECT_LT(blocked, 3600);
  EXPECT_EQ(differ, 0);
}

TEST_F(Collisions, AMotionIsProvenWhereSmallStepsFindNothingAndBlockedWhereTheyFindSomething) {
  const CollisionWorld world(arm_, attached_, obstacles_, kTouching);
  int blocked = 0;
  for (int i = 0; i < 400; ++i) {
    const Joints from = testing::randomJoints(arm_, random_, 0.6);
    const Joints to = from + 0.2 * testing::randomJoints(arm_, random_, 1.0);
    bool found = false;
    for (int k = 0; k <= 400 && !found; ++k) found = world.collides(from + k / 400.0 * (to - from));
    const auto contact = world.firstContact(from, to, 0.002);
    if (contact) ++blocked;
    ASSERT_EQ(contact.has_value(), found) << i;
  }
  EXPECT_GT(blocked, 20);
}

TEST_F(Collisions, AThinPlateIsNotJumped) {
  const Joints from = testing::working() - 0.5 * Joints::Unit(7, 0),
               to = testing::working() + 0.5 * Joints::Unit(7, 0);
  const Eigen::Vector3d before_the_hand =
      Kinematics(arm_).flange(testing::working()) * Eigen::Vector3d(0.0, 0.0, 0.1);
  const std::vector<Obstacle> plate = {
      {makeTransform(Eigen::Quaterniond::Identity(), before_the_hand), {0.02, 1e-4, 0.02}}};
  const std::vector<Capsule> needle = {{7, {0.0, 0.0, 0.05}, {0.0, 0.0, 0.12}, 1e-4, ArmPart::kSling}};
  const auto contact = CollisionWorld(arm_, needle, plate, kTouching).firstContact(from, to, 1e-4);
  ASSERT_TRUE(contact);
  EXPECT_EQ(contact->part, ArmPart::kSling);
}

TEST_F(Collisions, WhatIsTooNearIsRefusedAtTheDistanceAskedFor) {
  obstacles_ = {obstacles_.back()};  // the table is nearer than 5 cm to the lowest link in every posture
  const CollisionWorld touching(arm_, attached_, obstacles_, kTouching);
  const CollisionWorld keeping(arm_, attached_, obstacles_, {.self_m = 0.03, .obstacle_m = 0.05});
  const CollisionWorld grown = [&] {
    std::vector<Obstacle> larger = obstacles_;
    for (Obstacle& obstacle : larger) obstacle.round_m += 0.05;
    return CollisionWorld(arm_, attached_, larger, {.self_m = 0.03, .obstacle_m = 0.0});
  }();
  int between = 0;
  for (int i = 0; i < 4000; ++i) {
    const Joints q = testing::randomJoints(arm_, random_, 0.8);
    ASSERT_EQ(keeping.collides(q), grown.collides(q)) << i;
    if (keeping.collides(q) && !touching.collides(q)) ++between;
    ASSERT_TRUE(keeping.collides(q) || !touching.collides(q)) << i;
  }
  EXPECT_GT(between, 50);
}

TEST_F(Collisions, WhatIsAdmittedMayStayAsNearButNoNearer) {
  CollisionWorld world(arm_, attached_, obstacles_, {.self_m = 0.03, .obstacle_m = 0.05});
  const CollisionWorld touching(arm_, attached_, obstacles_, kTouching);
  int admitted = 0, nearer_refused = 0;
  for (int i = 0; i < 2000; ++i) {
    const Joints q = testing::randomJoints(arm_, random_, 0.8);
    if (!world.collides(q)) continue;
    world.admit(q);
    EXPECT_EQ(world.collides(q), touching.collides(q));
    if (!touching.collides(q)) {
      ++admitted;
      for (int k = 0; k < 20; ++k) {
        const Joints beside = q + 0.02 * testing::randomJoints(arm_, random_, 1.0);
        if (world.collides(beside)) ++nearer_refused;
      }
    }
    world.admitNothing();
    EXPECT_TRUE(world.collides(q));
  }
  EXPECT_GT(admitted, 50);
  EXPECT_GT(nearer_refused, 5 * admitted);
}

TEST_F(Collisions, EdgesOfABoxMayBeRound) {
  const CollisionWorld without(arm_, {}, {}, kTouching);
  const Joints q = testing::working();
  ASSERT_FALSE(without.collides(q));
  // Diagonally off an edge: the square box around would reach it, the rounded one does not.
  const RigidTransform X_BF = Kinematics(arm_).flange(q);
  const std::vector<Capsule> tip = {{7, {0.0, 0.0, 0.3}, {0.0, 0.0, 0.3}, 0.01, ArmPart::kSling}};
  const auto collides = [&](double gap) {
    Obstacle box{X_BF * Eigen::Translation3d(0.05 + gap, 0.05 + gap, 0.3), {0.1, 0.1, 0.1}};
    box.round_m = 0.05;
    return CollisionWorld(arm_, tip, std::vector<Obstacle>{box}, kTouching).collides(q);
  };
  EXPECT_TRUE(collides(0.040));
  EXPECT_FALSE(collides(0.044));  // 0.044 * sqrt(2) > 0.05 + 0.01
}

}  // namespace mirrorarm::robot
