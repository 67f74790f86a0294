#include <cmath>
#include <optional>
#include <random>
#include <stdexcept>
#include <vector>

#include "benchmarks/robot/bench_arm.h"
#include "benchmarks/robot/rrt_first.h"
#include "benchmarks/robot/suite.h"
#include "benchmarks/timing.h"
#include "core/common/resources.h"
#include "core/robot/kinematics.h"
#include "core/robot/planner.h"
#include "core/robot/surroundings.h"
#include "core/robot/trajectory.h"

namespace mirrorarm::benchmarks::robot {
namespace {

using namespace mirrorarm::robot;

constexpr double kSplineStep_rad = 0.01;
constexpr double kMicroseconds = 1000.0;  // of a millisecond

template <class T>
T read(FromFile<T> from_file) {
  if (!from_file) throw std::runtime_error(describe(from_file.error()));
  return std::move(*from_file);
}

/// The bench's arm with its hand, table and head.
struct Bench {
  ArmDescription arm = lbr();
  std::vector<Capsule> attached = handOn(arm);
  std::vector<Obstacle> surroundings = read(readSurroundings(resourceFolder() / "robots/surroundings.yaml"));
  MotionLimits limits = *limitsOf("therapy", arm);
};

/// A way between two clear postures, and what stands around.
struct Problem {
  Joints from, to;
  std::vector<Obstacle> obstacles;
};

class Problems {
 public:
  explicit Problems(const Bench& bench) : bench_(bench), kinematics_(bench.arm) {}

  /// A box stands on the straight way.
  Problem blocked() {
    for (;;) {
      Problem problem{around(0.5), around(0.5), bench_.surroundings};
      const Joints middle = 0.5 * (problem.from + problem.to);
      const Eigen::Vector3d size(length(0.05, 0.15), length(0.05, 0.15), length(0.05, 0.15));
      problem.obstacles.push_back(
          {makeTransform(Eigen::Quaterniond::Identity(), kinematics_.flange(middle).translation()), size,
           ObstacleKind::kBox, "between"});
      const CollisionWorld world(bench_.arm, bench_.attached, problem.obstacles);
      if (!world.collides(problem.from) && !world.collides(problem.to)) return problem;
    }
  }

  /// 0.2 rad away in one joint's measure, nothing between.
  Problem clear() {
    for (;;) {
      Problem problem{around(0.4), {}, bench_.surroundings};
      Joints way = around(0.4) - problem.from;
      problem.to = problem.from + 0.2 / way.norm() * way;
      const CollisionWorld world(bench_.arm, bench_.attached, problem.obstacles);
      if (!world.firstContact(problem.from, problem.to, 0.005)) return problem;
    }
  }

 private:
  /// Near the posture in which the bench works.
  Joints around(double spread) {
    Joints q(7);
    q << 0.0, -0.48, 0.0, 1.45, 0.0, -1.21, 0.0;
    for (double& angle : q) angle += length(-spread, spread);
    return q;
  }
  double length(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }

  const Bench& bench_;
  Kinematics kinematics_;
  std::mt19937 random_{static_cast<std::mt19937::result_type>(kSeed)};
};

/// The motion through the way points keeps the guard's distances, looked at every 0.01 rad.
bool splineIsClear(const CollisionWorld& world, const Joints& from, const PlannedPath& path,
                   const MotionLimits& limits) {
  const auto zero = Joints::Zero(from.size());
  const Trajectory motion = Trajectory::through({from, zero, zero}, path.waypoints, TimePoint{}, limits);
  const int samples = static_cast<int>(
      std::ceil(motion.duration().count() * limits.max_speed_rad_s.maxCoeff() / kSplineStep_rad));
  for (int i = 0; i <= samples; ++i)
    if (world.collides(motion.at(TimePoint{} + toClock(motion.duration() * (1.0 * i / samples))).q_rad))
      return false;
  return true;
}

double lengthOf(const Joints& from, const PlannedPath& path) {
  double length = 0.0;
  Joints last = from;
  for (const Joints& next : path.waypoints) {
    length += (next - last).norm();
    last = next;
  }
  return length;
}

void measureBlocked(Run& run, const Bench& bench) {
  const int count = run.trials(600, 30);
  Problems problems(bench);
  std::vector<Problem> asked;
  std::vector<Planner> planners;
  while (static_cast<int>(asked.size()) < count) {
    asked.push_back(problems.blocked());
    planners.emplace_back(bench.arm, bench.attached, asked.back().obstacles, PlannerSettings{});
    if (!planners.back().directIsClear(asked.back().from, asked.back().to)) continue;
    asked.pop_back();
    planners.pop_back();
  }
  std::vector<std::optional<PlannedPath>> paths(asked.size());
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  const Timing planned = timed(count, [&](int i) {
    if (auto path = planners[at(i)].plan(asked[at(i)].from, asked[at(i)].to)) paths[at(i)] = std::move(*path);
  });
  int solved = 0, smooth = 0;
  std::vector<double> ratios;
  const Timing checked = timed(count, [&](int i) {
    if (!paths[at(i)]) return;
    ++solved;
    const CollisionWorld world(bench.arm, bench.attached, asked[at(i)].obstacles);
    if (splineIsClear(world, asked[at(i)].from, *paths[at(i)], bench.limits)) ++smooth;
  });
  for (int i = 0; i < count; ++i)
    if (paths[at(i)])
      ratios.push_back(lengthOf(asked[at(i)].from, *paths[at(i)]) /
                       (asked[at(i)].to - asked[at(i)].from).norm());
  const double of_all = 100.0 / count;
  run.report.rows.push_back({"",
                             "Blocked by a box: planned and shortened",
                             "p99 <= 20 ms",
                             {{"median", planned.median_ms, "ms"},
                              {"p99", planned.p99_ms, "ms"},
                              {"solved", of_all * solved, "%"},
                              {"length / straight, median", quantile(ratios, 0.5), ""},
                              {"length / straight, p99", quantile(ratios, 0.99), ""}},
                             {},
                             planned.p99_ms <= 20.0});
  run.report.rows.push_back(
      {"",
       "The motion along it, timed and checked every 0.01 rad",
       "",
       {{"median", checked.median_ms, "ms"}, {"p99", checked.p99_ms, "ms"}, {"clear", of_all * smooth, "%"}},
       {},
       {}});
}

void measureClear(Run& run, const Bench& bench) {
  const int count = run.trials(300, 20);
  Problems problems(bench);
  const CollisionWorld world(bench.arm, bench.attached, bench.surroundings);
  Planner planner(bench.arm, bench.attached, bench.surroundings, {});
  std::vector<Problem> asked;
  for (int i = 0; i < count; ++i) asked.push_back(problems.clear());
  double longest = 0.0;
  const Timing direct = timed(count, [&](int i) {
    const Problem& problem = asked[static_cast<std::size_t>(i)];
    if (const auto path = planner.plan(problem.from, problem.to))
      longest = std::max(longest, lengthOf(problem.from, *path) / (problem.to - problem.from).norm());
  });
  std::vector<double> rrt_ratios;
  const Timing rrt = timed(count, [&](int i) {
    const Problem& problem = asked[static_cast<std::size_t>(i)];
    const auto length = rrtFirstLength(jointRanges(bench.arm), problem.from, problem.to,
                                       [&](const Joints& q) { return !world.collides(q); });
    if (length) rrt_ratios.push_back(*length / (problem.to - problem.from).norm());
  });
  run.report.rows.push_back({"",
                             "Small clear move (0.2 rad), direct edge first",
                             "path as long as the straight one",
                             {{"longest / straight", longest, ""},
                              {"median", kMicroseconds * direct.median_ms, "us"},
                              {"p99", kMicroseconds * direct.p99_ms, "us"}},
                             {{"RRT first: length / straight, median", quantile(rrt_ratios, 0.5), ""},
                              {"RRT first: median", kMicroseconds * rrt.median_ms, "us"}},
                             longest < 1.0001 && longest > 0.0});
}

void measureChecks(Run& run, const Bench& bench) {
  const int count = run.trials(50'000, 1000);
  Problems problems(bench);
  std::vector<Problem> asked;
  for (int i = 0; i < 100; ++i) asked.push_back(problems.clear());
  const CollisionWorld world(bench.arm, bench.attached, bench.surroundings);
  int blocked = 0;
  const auto at = [&](int i) -> const Problem& { return asked[static_cast<std::size_t>(i) % asked.size()]; };
  const Timing state = timed(count, [&](int i) { blocked += world.collides(at(i).from) ? 1 : 0; });
  const Timing edge =
      timed(count, [&](int i) { blocked += world.firstContact(at(i).from, at(i).to, 0.005) ? 1 : 0; });
  if (blocked > 0) throw std::runtime_error("a clear posture is said to collide");
  run.report.rows.push_back({"",
                             "Collision check with table, head, bar and sling",
                             "",
                             {{"posture, median", kMicroseconds * state.median_ms, "us"},
                              {"motion of 0.2 rad, median", kMicroseconds * edge.median_ms, "us"}},
                             {},
                             {}});
}

}  // namespace

void measurePlanning(Run& run) {
  const Bench bench;
  measureBlocked(run, bench);
  measureClear(run, bench);
  measureChecks(run, bench);
}

}  // namespace mirrorarm::benchmarks::robot
