#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "core/tracking/clique_search.h"

using namespace mirrorarm::tracking;

namespace {

bool areJoined(const CompatibilityGraph& graph, Pairing a, Pairing b) {
  return (graph.joined(a) & markerBit(b.marker)) != 0 && graph.neighbours(a, b.marker).holds(b.point);
}

bool isClique(const CompatibilityGraph& graph, std::span<const Pairing> pairings) {
  for (const Pairing& a : pairings)
    for (const Pairing& b : pairings)
      if (&a != &b && !areJoined(graph, a, b)) return false;
  return true;
}

/// Asks for ever larger cliques.
struct Largest : CliqueJudge {
  explicit Largest(const CompatibilityGraph& of) : graph(of) {}
  bool mayJoin(std::span<const Pairing, 3>, Pairing) override { return true; }
  int judge(std::span<const Pairing> clique) override {
    EXPECT_TRUE(isClique(graph, clique));
    best.assign(clique.begin(), clique.end());
    return static_cast<int>(clique.size()) + 1;
  }
  const CompatibilityGraph& graph;
  std::vector<Pairing> best;
};

/// The largest clique's size by trying all, that holds a pairing outside `known`.
int largestByTrying(const CompatibilityGraph& graph, std::span<const PointSet> known,
                    std::vector<Pairing>& chosen, int marker, bool is_new) {
  if (marker == graph.markers()) return is_new ? static_cast<int>(chosen.size()) : 0;
  int best = largestByTrying(graph, known, chosen, marker + 1, is_new);
  for (int point = 0; point < graph.points(); ++point) {
    const Pairing next{marker, point};
    if (!std::ranges::all_of(chosen, [&](const Pairing& one) { return areJoined(graph, one, next); }))
      continue;
    const bool is_other = known.empty() || !known[static_cast<std::size_t>(marker)].holds(point);
    chosen.push_back(next);
    best = std::max(best, largestByTrying(graph, known, chosen, marker + 1, is_new || is_other));
    chosen.pop_back();
  }
  return best;
}

/// Points past the 64th too, so that both words of a set are used.
CompatibilityGraph randomGraph(double density, std::mt19937& rng) {
  constexpr int markers = 6, points = 70;
  std::bernoulli_distribution is_joined(density);
  CompatibilityGraph graph;
  graph.reset(markers, points);
  for (int a = 0; a < markers; ++a)
    for (int b = 0; b < a; ++b)
      for (int k = 60; k < points; ++k)
        for (int l = 60; l < points; ++l)
          if (k != l && is_joined(rng)) graph.join({a, k}, {b, l});
  return graph;
}

}  // namespace

TEST(CliqueSearch, FindsTheLargestCliqueOfRandomGraphs) {
  std::mt19937 rng(1);
  CliqueSearch search;
  for (int trial = 0; trial < 200; ++trial) {
    const CompatibilityGraph graph = randomGraph(trial % 2 == 0 ? 0.2 : 0.5, rng);
    Largest largest(graph);
    int steps = 1'000'000;
    ASSERT_TRUE(search.run(graph, 2, {}, largest, steps));
    std::vector<Pairing> chosen;
    EXPECT_EQ(static_cast<int>(largest.best.size()), largestByTrying(graph, {}, chosen, 0, true)) << trial;
  }
}

TEST(CliqueSearch, FindsTheLargestCliqueThatIsNotAllKnown) {
  std::mt19937 rng(2);
  CliqueSearch search;
  for (int trial = 0; trial < 200; ++trial) {
    const CompatibilityGraph graph = randomGraph(0.4, rng);
    std::vector<PointSet> known(static_cast<std::size_t>(graph.markers()));
    for (int point = 60; point < graph.points(); ++point)
      for (PointSet& points : known)
        if (rng() % 8 != 0) points |= PointSet::of(point);
    Largest largest(graph);
    int steps = 1'000'000;
    ASSERT_TRUE(search.run(graph, 2, known, largest, steps));
    std::vector<Pairing> chosen;
    const int expected = largestByTrying(graph, known, chosen, 0, false);
    EXPECT_EQ(static_cast<int>(largest.best.size()), expected < 2 ? 0 : expected) << trial;
  }
}

TEST(CliqueSearch, EndsWhenItsStepsAreUsedUp) {
  std::mt19937 rng(3);
  const CompatibilityGraph graph = randomGraph(0.9, rng);
  Largest largest(graph);
  int steps = 10;
  EXPECT_FALSE(CliqueSearch().run(graph, 2, {}, largest, steps));
  EXPECT_EQ(steps, 0);
}
