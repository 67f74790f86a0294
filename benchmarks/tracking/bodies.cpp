#include <algorithm>
#include <cstdint>

#include "benchmarks/statistics.h"
#include "benchmarks/timing.h"
#include "benchmarks/tracking/marker_world.h"
#include "benchmarks/tracking/suite.h"
#include "core/tracking/constellation_search.h"

namespace mirrorarm::benchmarks::tracking {
namespace {

namespace product = mirrorarm::tracking;

constexpr int kBodies = 8;
constexpr int kMarkers = 10;
constexpr int kStrangers = 20;
constexpr double kAside_m = 0.3;
constexpr double kLeastDistance_m = 0.15;  // of bodies: they do not go through each other
constexpr double kMostMedian_ms = 2.0;

/// Eight different bodies in one view.
struct Company {
  std::vector<Layout> layouts;
  std::vector<Placed> placed;
  MarkerScene scene;
};

void meet(int index, int visible, Company& company) {
  TrialRandom random(kSeed, static_cast<std::uint64_t>(80000 + visible), static_cast<std::uint64_t>(index));
  company.layouts.clear();
  company.placed.clear();
  for (int body = 0; body < kBodies; ++body) company.layouts.push_back(randomLayout(kMarkers, random));
  while (company.placed.size() < company.layouts.size()) {
    const RigidTransform X_CT = randomPose(random, kAside_m);
    const auto isApart = [&](const Placed& other) {
      return (other.X_CT.translation() - X_CT.translation()).norm() >= kLeastDistance_m;
    };
    if (std::ranges::all_of(company.placed, isApart))
      company.placed.push_back({&company.layouts[company.placed.size()], X_CT, visible});
  }
  company.scene = look(company.placed, kStrangers, random);
}

Row measureCompany(const std::string& name, int visible, int frames) {
  product::ConstellationSearch search;
  std::vector<double> times_ms;
  int right = 0, wrong = 0;
  Company company;
  for (int i = 0; i < frames; ++i) {
    meet(i, visible, company);
    search.setTargets(
        std::vector<std::span<const Eigen::Vector3d>>(company.layouts.begin(), company.layouts.end()));
    const TimePoint start = Clock::now();
    const auto results = search.run(company.scene.cloud);
    times_ms.push_back(1000.0 * secondsBetween(start, Clock::now()));
    for (int body = 0; body < kBodies; ++body) {
      const auto& result = results[static_cast<std::size_t>(body)];
      if (result.verdict != product::SearchVerdict::kFound) continue;
      const auto& X_CT = company.placed[static_cast<std::size_t>(body)].X_CT;
      ++(isRight(company.scene, body, X_CT, result.best.X_CT, result.best.point_of_marker) ? right : wrong);
    }
  }
  Row row;
  row.name = name;
  row.goal = "all found, median <= 2 ms";
  row.measured = {{"right", 100.0 * right / (kBodies * frames), "%"},
                  {"wrong", 1.0 * wrong, ""},
                  {"bodies sought", 1.0 * kBodies * frames, ""},
                  {"median", quantile(times_ms, 0.5), "ms"},
                  {"p99", quantile(times_ms, 0.99), "ms"}};
  row.pass = right == kBodies * frames && quantile(times_ms, 0.5) <= kMostMedian_ms;
  return row;
}

}  // namespace

void measureBodies(Run& run) {
  const int frames = run.trials(3000, 30);
  run.report.rows.push_back(measureCompany("8 bodies of 10 markers, 20 spurious", kMarkers, frames));
  run.report.rows.push_back(measureCompany("the same, 6 of 10 markers seen", 6, frames));
}

}  // namespace mirrorarm::benchmarks::tracking
