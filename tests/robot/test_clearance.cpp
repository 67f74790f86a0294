#include <gtest/gtest.h>

#include "core/robot/clearance.h"
#include "core/robot/collision.h"
#include "core/robot/kinematics.h"
#include "tests/common/no_heap.h"
#include "tests/robot/arms.h"

namespace mirrorarm::robot {
namespace {

constexpr double kPeriod_s = 0.001;

std::vector<Capsule> attached() {
  const int last = testing::lbr().jointCount();
  return {{last, {-0.06, 0.08, 0.09}, {0.06, 0.08, 0.09}, 0.025, ArmPart::kCameraBar},
          {last, {0.0, 0.0, 0.10}, {0.0, 0.0, 0.17}, 0.02, ArmPart::kSling}};
}

/// A table, a tilted box and a head around the arm.
std::vector<Obstacle> room() {
  Obstacle table{makeTransform(Eigen::Quaterniond::Identity(), {0.6, 0.0, 0.05}),
                 {0.8, 1.2, 0.04},
                 ObstacleKind::kTable};
  Obstacle box{
      makeTransform(Eigen::Quaterniond(Eigen::AngleAxisd(0.5, Eigen::Vector3d(1, 2, 3).normalized())),
                    {0.3, 0.5, 0.6}),
      {0.2, 0.3, 0.4}};
  return {table, box, ball(ObstacleKind::kHead, {0.7, -0.3, 0.7}, 0.15)};
}

/// Of one pair alone; not a number where it is none of the nearest.
double distanceOf(Clearance& clearance, const Joints& q, const ShapePair& pair) {
  const auto rows = clearance.rows(q, q);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const ShapePair& other = clearance.pair(static_cast<int>(i));
    if (other.shape == pair.shape && other.other == pair.other && other.obstacle == pair.obstacle)
      return rows[i].distance_m;
  }
  return std::nan("");
}

}  // namespace

TEST(Clearance, AgreesWithTheCollisionWorldOnWhatTouches) {
  const ArmDescription arm = testing::lbr();
  Clearance clearance(arm, attached(), room(), {.keep = kTouching});
  const CollisionWorld world(arm, attached(), room(), kTouching);
  std::mt19937 random(3);
  int touching = 0;
  for (int i = 0; i < 20000; ++i) {
    const Joints q = testing::randomJoints(arm, random, 1.0);
    const double least = clearance.leastRoom(q);
    ASSERT_EQ(least < 0.0, world.collides(q)) << i << ": " << least;
    if (least < 0.0) ++touching;
  }
  EXPECT_GT(touching, 2000);
}

TEST(Clearance, GradientsAreThoseOfTheDistance) {
  const ArmDescription arm = testing::lbr();
  Clearance clearance(arm, attached(), room());
  std::mt19937 random(4);
  int compared = 0, far_off = 0;
  for (int i = 0; i < 1000; ++i) {
    const Joints q = testing::randomJoints(arm, random, 0.8);
    const auto found = clearance.rows(q, q);
    const std::vector<ClearanceRow> rows(found.begin(), found.end());
    std::vector<ShapePair> pairs;
    for (std::size_t k = 0; k < rows.size(); ++k) pairs.push_back(clearance.pair(static_cast<int>(k)));
    for (std::size_t k = 0; k < rows.size() / 2; ++k) {
      if (rows[k].distance_m < 0.0) continue;
      for (int j = 0; j < 7; ++j) {
        Joints ahead = q, behind = q;
        ahead[j] += 1e-6;
        behind[j] -= 1e-6;
        const double slope =
            (distanceOf(clearance, ahead, pairs[k]) - distanceOf(clearance, behind, pairs[k])) / 2e-6;
        if (std::isnan(slope)) continue;
        ++compared;
        if (std::abs(slope - rows[k].gradient[j]) > 1e-4) ++far_off;  // at an edge of the distance
      }
    }
  }
  EXPECT_GT(compared, 10000);
  EXPECT_LT(far_off, compared / 100);
}

TEST(Clearance, TakesNothingFromTheHeap) {
  if (!::mirrorarm::testing::heapIsCounted) GTEST_SKIP() << "a sanitizer owns the heap";
  const ArmDescription arm = testing::lbr();
  Clearance clearance(arm, attached(), room());
  std::mt19937 random(5);
  std::size_t calls = 0, rows = 0;
  for (int i = 0; i < 100; ++i) {
    const Joints q = testing::randomJoints(arm, random, 0.6);
    calls += ::mirrorarm::testing::heapCallsIn([&] { rows += clearance.rows(q, q).size(); });
  }
  EXPECT_EQ(calls, 0U);
  EXPECT_GT(rows, 100U);
}

TEST(Clearance, SlowsNearTheHeadAndNotFarFromIt) {
  const ArmDescription arm = testing::lbr();
  const Kinematics kinematics(arm);
  const Joints q = testing::working();
  const Eigen::Vector3d flange = kinematics.flange(q).translation();
  const auto speedAt = [&](double away_m) {
    const Eigen::Vector3d head = flange + Eigen::Vector3d(away_m, 0.0, 0.0);
    const std::vector<Obstacle> heads{ball(ObstacleKind::kHead, head, 0.15)};
    Clearance clearance(arm, {}, heads);
    static_cast<void>(clearance.rows(q, q));
    return clearance.zoneSpeed();
  };
  EXPECT_NEAR(speedAt(0.25), 0.13, 1e-9);
  EXPECT_GT(speedAt(0.45), 0.2);
  EXPECT_GT(speedAt(0.60), 0.3);
  EXPECT_TRUE(std::isinf(speedAt(3.0)));
  Clearance nothing;
  EXPECT_TRUE(nothing.rows(q, q).empty());
  EXPECT_TRUE(std::isinf(nothing.zoneSpeed()));
}

/// The arm with guard and clearances, cycle by cycle.
class GuardedArm {
 public:
  GuardedArm() : last(restAt(testing::working())) {}
  Guarded step(const MotionState& wish) {
    const Jacobian J = kinematics.jacobian(last.q_rad);
    const auto rows = clearance.rows(last.q_rad, restOf(last, kPeriod_s));
    const Surroundings around{
        .jacobian = J, .clearances = rows, .zone_speed_m_s = clearance.zoneSpeed(), .hand = clearance.hand()};
    const Guarded guarded = guardMotion(wish, last, around, kPeriod_s, limits);
    last = guarded.command;
    return guarded;
  }
  Guarded toward(const Joints& q) { return step({q, Joints::Zero(7), Joints::Zero(7)}); }

  ArmDescription arm = testing::lbr();
  Kinematics kinematics{arm};
  MotionLimits limits = *limitsOf("therapy", arm);
  Clearance clearance{arm, attached(), room()};
  Clearance watch{arm, attached(), room()};
  Commanded last;
};

TEST(GuardedClearance, WhatIsWishedInsideThingsIsHeldOff) {
  GuardedArm guarded;
  std::mt19937 random(6);
  double least = 1e9;
  int collisions = 0;
  for (int round = 0; round < 60; ++round) {
    const Joints goal = testing::randomJoints(guarded.arm, random, 0.7);
    for (int cycle = 0; cycle < 1500; ++cycle) {
      if (guarded.toward(goal).action == GuardAction::kCollision) ++collisions;
      if (cycle % 4 == 0) least = std::min(least, guarded.watch.leastRoom(guarded.last.q_rad));
    }
  }
  EXPECT_GT(least, -0.001);
  EXPECT_GT(collisions, 300);
}

TEST(GuardedClearance, GoingAwayIsNotSlowed) {
  GuardedArm guarded;
  Joints down = testing::working();
  down[1] = -1.6;
  for (int cycle = 0; cycle < 6000; ++cycle) guarded.toward(down);
  const Joints near = guarded.last.q_rad;
  ASSERT_LT(guarded.watch.leastRoom(near), 0.01);
  const TimePoint start{std::chrono::hours(1)};
  MotionLimits inside = guarded.limits;
  inside.max_speed_rad_s *= 0.98;
  inside.max_acceleration_rad_s2 *= 0.98;
  inside.max_jerk_rad_s3 *= 0.98;
  const Joints up = near + 0.25 * Joints::Unit(7, 1);
  const Trajectory away = Trajectory::quintic({near, Joints::Zero(7), Joints::Zero(7)}, up, start, inside);
  for (int cycle = 1; cycle < 1500; ++cycle) {
    const Guarded sent = guarded.step(away.at(start + toClock(Seconds(cycle * kPeriod_s))));
    ASSERT_EQ(sent.action, GuardAction::kPassed) << id(sent.action) << " at " << cycle;
  }
}

TEST(GuardedClearance, TheToolIsSlowBeforeItIsNearTheHead) {
  GuardedArm guarded;
  const Eigen::Vector3d head(0.7, -0.3, 0.7);
  Joints goal = testing::working();
  goal[0] = -1.2;
  goal[1] = -0.4;
  Eigen::Vector3d before = guarded.kinematics.flange(guarded.last.q_rad).translation();
  double fastest_near = 0.0, fastest = 0.0;
  for (int cycle = 0; cycle < 6000; ++cycle) {
    guarded.toward(goal);
    const Eigen::Vector3d now = guarded.kinematics.flange(guarded.last.q_rad).translation();
    const double speed = (now - before).norm() / kPeriod_s;
    before = now;
    fastest = std::max(fastest, speed);
    // The flange is part of the arm: within 0.1 m of the head it is as slow as the head's profile says.
    if ((now - head).norm() < 0.15 + 0.10) fastest_near = std::max(fastest_near, speed);
  }
  EXPECT_LT(fastest_near, 0.1301);
  EXPECT_GT(fastest, fastest_near) << "farther off";
}

TEST(GuardedClearance, TheWholeHandIsSlowNearTheHead) {
  GuardedArm guarded;
  const std::vector<Capsule> hand = attached();
  const auto tips = [&] {
    std::vector<Eigen::Vector3d> points;
    const RigidTransform X_BL = guarded.kinematics.link(guarded.last.q_rad, 7);
    for (const Capsule& capsule : hand) {
      points.push_back(X_BL * capsule.a);
      points.push_back(X_BL * capsule.b);
    }
    return points;
  };
  std::mt19937 random(11);
  double fastest = 0.0, flange = 0.0;
  for (int turn = 0; turn < 40; ++turn) {  // past the head and back, while elbow and wrist turn the hand
    Joints wish = testing::working();
    wish[0] = turn % 2 == 0 ? -1.0 : 0.2;
    for (const int joint : {2, 4, 5, 6})
      wish[joint] += std::uniform_real_distribution<double>(-1.0, 1.0)(random);
    for (int cycle = 0; cycle < 2500; ++cycle) {
      const auto before = tips();
      const Eigen::Vector3d origin = guarded.kinematics.flange(guarded.last.q_rad).translation();
      guarded.toward(wish);
      if (guarded.clearance.zoneSpeed() > 0.13) continue;
      const auto after = tips();
      for (std::size_t i = 0; i < after.size(); ++i)
        fastest = std::max(fastest, (after[i] - before[i]).norm() / kPeriod_s);
      flange = std::max(
          flange, (guarded.kinematics.flange(guarded.last.q_rad).translation() - origin).norm() / kPeriod_s);
    }
  }
  EXPECT_LT(fastest, 0.1301);
  EXPECT_GT(fastest, 0.12);
  EXPECT_LT(flange, 0.1301);
}

}  // namespace mirrorarm::robot
