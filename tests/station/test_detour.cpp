#include "bench_session.h"
#include "core/robot/collision.h"
#include "core/simulation/bench_layout.h"

namespace mirrorarm::station {
namespace {

constexpr double kAcross_m = 0.20;
constexpr double kRest_s = 6.0;

/// Stands on the table across the sling's way.
robot::Obstacle pole(double across_m, double wide_m, double height_m) {
  const Eigen::Vector3d start = simulation::bench_layout::startX_BF().translation();
  const RigidTransform X_BO(Eigen::Translation3d(start.x(), across_m, 0.5 * height_m));
  return {X_BO, {wide_m, 0.02, height_m}, robot::ObstacleKind::kBox, "pole"};
}

/// The forearm goes across and back, and rests on both sides; it begins once the robot follows.
simulation::BenchSettings acrossAndBack() {
  auto bench = benchFor("side");
  bench.legs = {{{0.0, 0.0, 0.0}, 0.0, 1.0, 3.0},
                {{0.0, kAcross_m, 0.0}, 0.0, 4.0, kRest_s},
                {{0.0, 0.0, 0.0}, 0.0, 4.0, kRest_s}};
  return bench;
}

/// What was seen while a session ran.
struct Seen {
  bool blocked = false, planned = false, named = false;
  int too_near = 0;
  double across_m = 0.0;  ///< the farthest the sling came
};

Seen watch(BenchSession& session, const robot::Obstacle& obstacle) {
  const auto equipment = equipmentOf(session.bench());
  auto obstacles = equipment.obstacles;
  obstacles.push_back(obstacle);
  const robot::CollisionWorld a_hair_less(equipment.arm, equipment.attached, obstacles,
                                          {.self_m = 0.009, .obstacle_m = 0.019});
  Seen seen;
  const auto look = [&](const Snapshot& snapshot) {
    const auto& control = snapshot.control;
    seen.blocked = seen.blocked || control.follow == control::FollowOutcome::kBlocked;
    seen.planned = seen.planned || control.follow == control::FollowOutcome::kPlanned;
    seen.named = seen.named || (control.contact && control.contact->name == "pole");
    const auto& q = control.servo.measured.q_rad;
    if (q.size() > 0 && a_hair_less.collides(q)) ++seen.too_near;
    const auto X_BE = session.bench().truthAt(session.now()).X_BF * equipment.X_FE;
    seen.across_m = std::max(seen.across_m, X_BE.translation().y());
    return false;
  };
  EXPECT_EQ(session.runUntil(look), SessionScript::Progress::kDone) << session.script().failure();
  return seen;
}

}  // namespace

TEST(Detour, TheArmGoesAroundAPoleAndFollowsOn) {
  const robot::Obstacle obstacle = pole(0.5 * kAcross_m, 0.03, 0.36);
  BenchSession session({.training = Seconds(14.0)}, acrossAndBack(), {}, {obstacle});
  const Seen seen = watch(session, obstacle);
  EXPECT_TRUE(seen.blocked) << "while the goal is inside the pole";
  EXPECT_TRUE(seen.named);
  EXPECT_TRUE(seen.planned);
  EXPECT_EQ(seen.too_near, 0);
  EXPECT_GT(seen.across_m, kAcross_m - 0.01);
  EXPECT_EQ(session.script().stops(), 0);
}

TEST(Detour, BeforeAWallTheArmWaitsAndSaysWhatStandsThere) {
  const robot::Obstacle wall = pole(0.15, 2.0, 0.9);
  BenchSession session({.training = Seconds(10.0)}, acrossAndBack(), {}, {wall});
  const Seen seen = watch(session, wall);
  EXPECT_TRUE(seen.blocked);
  EXPECT_TRUE(seen.named);
  EXPECT_EQ(seen.too_near, 0);
  EXPECT_LT(seen.across_m, 0.1);
  EXPECT_EQ(session.script().stops(), 0);
}

}  // namespace mirrorarm::station
