#include <array>
#include <cmath>
#include <numbers>

#include "benchmarks/timing.h"
#include "benchmarks/tracking/marker_world.h"
#include "benchmarks/tracking/nearest_neighbour_icp.h"
#include "benchmarks/tracking/suite.h"
#include "core/tracking/constellation_search.h"
#include "core/tracking/softassign.h"

namespace mirrorarm::benchmarks::tracking {
namespace {

using Eigen::Vector3d;
namespace product = mirrorarm::tracking;

constexpr double kIcpGate_m = 0.003;

/// What is sought in what, and what is asked of the answer.
struct Case {
  std::string_view name;
  int visible = 0;
  int strangers = 0;
  double most_median_us = 0.0;  ///< 0 for none
  double most_failures = 0.0;   ///< share that is neither right nor called ambiguous
};

constexpr std::array kCases{Case{"10 of 10 markers", 10, 0, 20.0, 0.0},
                            Case{"5 of 10 markers, 15 spurious", 5, 15, 60.0, 0.0},
                            Case{"4 of 10 markers, 10 spurious", 4, 10, 0.0, 0.001},
                            Case{"10 of 10 markers among 40 others", 10, 40, 600.0, 0.0}};

struct Trial {
  Layout markers_T;
  RigidTransform X_CT;
  MarkerScene scene;
};

/// A set of visible markers that no method could find a turn from is drawn anew.
Trial makeTrial(const Case& each, int index) {
  TrialRandom random(kSeed, static_cast<std::uint64_t>(1000 * each.visible + each.strangers),
                     static_cast<std::uint64_t>(index));
  for (;;) {
    Trial trial{randomLayout(10, random), randomPose(random), {}};
    const Placed placed{&trial.markers_T, trial.X_CT, each.visible};
    trial.scene = look(std::span(&placed, 1), each.strangers, random);
    if (fixesTurn(trial.scene, 0, trial.markers_T)) return trial;
  }
}

std::vector<Vector3d> positions(const MarkerScene& scene) {
  std::vector<Vector3d> points;
  for (const auto& point : scene.cloud) points.push_back(point.p_C);
  return points;
}

/// What came of many trials with one method.
struct Tally {
  int trials = 0, right = 0, ambiguous = 0, wrong = 0;
  Timing timing{};

  [[nodiscard]] double share(int count) const { return 100.0 * count / trials; }
  [[nodiscard]] int notFound() const { return trials - right - ambiguous - wrong; }
};

Tally seekConstellations(const Case& each, int trials) {
  Tally tally{.trials = trials};
  product::ConstellationSearch search;
  std::vector<double> times_ms;
  for (int i = 0; i < trials; ++i) {
    const Trial trial = makeTrial(each, i);
    search.setTargets(std::array{std::span<const Vector3d>(trial.markers_T)});
    const TimePoint start = Clock::now();
    const auto& result = search.run(trial.scene.cloud)[0];
    times_ms.push_back(1000.0 * secondsBetween(start, Clock::now()));
    if (result.verdict == product::SearchVerdict::kAmbiguous)
      ++tally.ambiguous;
    else if (result.verdict == product::SearchVerdict::kFound)
      ++(isRight(trial.scene, 0, trial.X_CT, result.best.X_CT, result.best.point_of_marker) ? tally.right
                                                                                            : tally.wrong);
  }
  tally.timing = {quantile(times_ms, 0.5), quantile(times_ms, 0.99)};
  return tally;
}

/// `registrar(x, y)` gives a pose and the point of each marker; what is not right counts as wrong.
template <class Registrar>
Tally tryReference(const Case& each, int trials, Registrar registrar) {
  Tally tally{.trials = trials};
  std::vector<double> times_ms;
  for (int i = 0; i < trials; ++i) {
    const Trial trial = makeTrial(each, i);
    const auto points_C = positions(trial.scene);
    const TimePoint start = Clock::now();
    const auto result = registrar(trial.markers_T, points_C);
    times_ms.push_back(1000.0 * secondsBetween(start, Clock::now()));
    ++(isRight(trial.scene, 0, trial.X_CT, result.X_YX, result.y_of_x) ? tally.right : tally.wrong);
  }
  tally.timing = {quantile(times_ms, 0.5), quantile(times_ms, 0.99)};
  return tally;
}

void addReference(const std::string& name, const Tally& tally, Row& row) {
  row.references.push_back({name + " right", tally.share(tally.right), "%"});
  row.references.push_back({name + " trials", 1.0 * tally.trials, ""});
  row.references.push_back({name + " median", 1000.0 * tally.timing.median_ms, "us"});
}

std::string goalOf(const Case& each) {
  const std::string share =
      each.most_failures == 0.0
          ? "all right"
          : ">= " + shortNumber(100.0 * (1.0 - each.most_failures)) + " % right or ambiguous";
  return each.most_median_us > 0.0 ? share + ", median <= " + shortNumber(each.most_median_us) + " us"
                                   : share;
}

Row rowOf(const Case& each, const Tally& ours) {
  Row row;
  row.name = each.name;
  row.goal = goalOf(each);
  row.measured = {{"right", ours.share(ours.right), "%"},
                  {"ambiguous", 1.0 * ours.ambiguous, ""},
                  {"wrong", 1.0 * ours.wrong, ""},
                  {"not found", 1.0 * ours.notFound(), ""},
                  {"of", 1.0 * ours.trials, ""},
                  {"median", 1000.0 * ours.timing.median_ms, "us"},
                  {"p99", 1000.0 * ours.timing.p99_ms, "us"}};
  const int excused = each.most_failures > 0.0 ? ours.ambiguous : 0;
  row.pass = ours.trials - ours.right - excused <= each.most_failures * ours.trials &&
             (each.most_median_us <= 0.0 || 1000.0 * ours.timing.median_ms <= each.most_median_us);
  return row;
}

}  // namespace

void measureRegistration(Run& run) {
  product::Softassign softassign;
  for (const Case& each : kCases) {
    Row row = rowOf(each, seekConstellations(each, run.trials(10000, 100)));
    addReference("softassign",
                 tryReference(each, run.trials(100, 3),
                              [&](const Layout& x, const std::vector<Vector3d>& y) {
                                return softassign.run(x, y, {});
                              }),
                 row);
    addReference("nearest-neighbour ICP",
                 tryReference(each, run.trials(3000, 50),
                              [](const Layout& x, const std::vector<Vector3d>& y) {
                                return nearestNeighbourIcp(x, y, kIcpGate_m);
                              }),
                 row);
    run.report.rows.push_back(row);
  }
}

}  // namespace mirrorarm::benchmarks::tracking
