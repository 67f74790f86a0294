#include <gtest/gtest.h>

#include "core/common/csv.h"
#include "core/tracking/constellation_search.h"
#include "tests/common/no_heap.h"
#include "tests/tracking/world.h"

using namespace mirrorarm;
using namespace mirrorarm::tracking;
using namespace mirrorarm::tracking::test;

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
using Markers = std::vector<Vector3d>;

std::vector<CloudPoint> asCloud(const std::vector<Vector3d>& points_C) {
  std::vector<CloudPoint> cloud;
  for (const auto& p : points_C)
    cloud.push_back({p, kSensorNoise_m * kSensorNoise_m * Eigen::Matrix3d::Identity(), {}});
  return cloud;
}

ConstellationSearch searchFor(const std::vector<Markers>& targets,
                              const ConstellationSettings& settings = {}) {
  ConstellationSearch search(settings);
  search.setTargets(std::vector<std::span<const Vector3d>>(targets.begin(), targets.end()));
  return search;
}

bool isRight(const SearchResult& result, const Scene& scene, const RigidTransform& X_CT) {
  for (std::size_t i = 0; i < result.best.point_of_marker.size(); ++i) {
    const int point = result.best.point_of_marker[i];
    if (point >= 0 && scene.marker_of_point[static_cast<std::size_t>(point)] != static_cast<int>(i))
      return false;
  }
  return (result.best.X_CT.translation() - X_CT.translation()).norm() < 0.0015 &&
         angleBetween(result.best.X_CT, X_CT) < 2.0 * kDegree;
}

/// How often the forearm is found where it is; nothing else may be called found.
int countFound(int trials, int visible, int strangers, unsigned seed) {
  const Target target = forearm();
  ConstellationSearch search = searchFor({target.markers_T});
  Noise noise(seed);
  int found = 0;
  for (int trial = 0; trial < trials; ++trial) {
    const RigidTransform X_CT = noise.pose();
    const Scene scene = look(target.markers_T, X_CT, visible, strangers, noise);
    const SearchResult& result = search.run(asCloud(scene.points_C))[0];
    if (result.verdict != SearchVerdict::kFound) continue;
    EXPECT_TRUE(isRight(result, scene, X_CT)) << trial;
    EXPECT_GE(result.best.matched, visible) << trial;
    ++found;
  }
  return found;
}

Scene joined(const std::vector<Scene>& scenes) {
  Scene all;
  for (const Scene& each : scenes) {
    all.points_C.insert(all.points_C.end(), each.points_C.begin(), each.points_C.end());
    all.marker_of_point.insert(all.marker_of_point.end(), each.marker_of_point.begin(),
                               each.marker_of_point.end());
  }
  return all;
}

Markers randomMarkers(int count, double reach_m, Noise& noise) {
  Markers markers;
  for (int i = 0; i < count; ++i)
    markers.emplace_back(noise.uniform(-reach_m, reach_m), noise.uniform(-reach_m, reach_m),
                         noise.uniform(-reach_m, reach_m));
  return markers;
}

/// The markers of a tool file of the shared data; empty when that is absent.
Markers toolMarkers(std::string_view file) {
  Markers markers;
  const auto table = CsvTable::read(SHARED_DATA "/plus-tracker/rom/markers_decoded.csv");
  if (!table) return markers;
  for (const CsvRow& row : table->rows())
    if (row.cells[0] == file)
      markers.push_back(0.001 *
                        Vector3d(*table->number(row, 2), *table->number(row, 3), *table->number(row, 4)));
  return markers;
}

/// The same body mirrored.
Markers mirrored(Markers markers) {
  for (auto& p : markers) p.x() = -p.x();
  return markers;
}

SearchVerdict verdictOn(const Markers& target, const Scene& scene,
                        const ConstellationSettings& settings = {}) {
  return searchFor({target}, settings).run(asCloud(scene.points_C))[0].verdict;
}

}  // namespace

TEST(ConstellationSearch, FindsAllMarkersInAnyOrientation) { EXPECT_EQ(countFound(2000, 10, 0, 1), 2000); }

TEST(ConstellationSearch, FindsHalfTheMarkersAmongStrangers) { EXPECT_EQ(countFound(2000, 5, 15, 2), 2000); }

// Some sets of four of these markers look like others of them.
TEST(ConstellationSearch, FindsFourMarkersAmongAFewStrangersOrSaysThatTheyAreAmbiguous) {
  const Target target = forearm();
  ConstellationSearch search = searchFor({target.markers_T});
  Noise noise(3);
  int found = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const RigidTransform X_CT = noise.pose();
    const Scene scene = look(target.markers_T, X_CT, 4, 10, noise);
    const SearchResult& result = search.run(asCloud(scene.points_C))[0];
    ASSERT_TRUE(result.verdict == SearchVerdict::kFound || result.verdict == SearchVerdict::kAmbiguous)
        << trial;
    if (result.verdict != SearchVerdict::kFound) continue;
    EXPECT_TRUE(isRight(result, scene, X_CT)) << trial;
    ++found;
  }
  EXPECT_GE(found, 1940);
}

TEST(ConstellationSearch, FindsAllMarkersInACrowd) { EXPECT_EQ(countFound(500, 10, 40, 4), 500); }

TEST(ConstellationSearch, ThreeOfManyMarkersAreNoProof) { EXPECT_EQ(countFound(500, 3, 10, 5), 0); }

TEST(ConstellationSearch, FindsEightBodiesAtOnce) {
  Noise noise(6);
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<Markers> targets;
    std::vector<RigidTransform> poses;
    std::vector<Scene> seen;
    for (int i = 0; i < 8; ++i) {
      targets.push_back(randomMarkers(10, 0.07, noise));
      poses.push_back(noise.pose());
      seen.push_back(look(targets.back(), poses.back(), 10, i < 4 ? 5 : 0, noise));
    }
    const Scene scene = joined(seen);
    ConstellationSearch search = searchFor(targets);
    const auto results = search.run(asCloud(scene.points_C));
    for (std::size_t i = 0, first = 0; i < 8; first += seen[i].points_C.size(), ++i) {
      ASSERT_EQ(results[i].verdict, SearchVerdict::kFound);
      EXPECT_EQ(results[i].best.matched, 10);
      for (std::size_t j = 0; j < 10; ++j) {
        const auto point = static_cast<std::size_t>(results[i].best.point_of_marker[j]);
        ASSERT_TRUE(point >= first && point - first < seen[i].points_C.size());
        EXPECT_EQ(scene.marker_of_point[point], static_cast<int>(j));
      }
    }
  }
}

TEST(ConstellationSearch, AMirroredBodyIsRefused) {
  const Target target = forearm();
  const Markers mirror = mirrored(target.markers_T);
  Noise noise(7);
  ConstellationSearch search = searchFor({target.markers_T});
  for (int trial = 0; trial < 200; ++trial) {
    const auto& result = search.run(asCloud(look(mirror, noise.pose(), 10, 5, noise).points_C))[0];
    EXPECT_NE(result.verdict, SearchVerdict::kFound);
    EXPECT_LE(result.best.matched, 5);  // such as lie on one plane
  }
}

TEST(ConstellationSearch, ABodyIsFoundBesideItsMirrorImage) {
  const Target target = forearm();
  Noise noise(8);
  for (int trial = 0; trial < 100; ++trial) {
    const RigidTransform X_CT = noise.pose();
    const Scene own = look(target.markers_T, X_CT, 6, 0, noise);
    const Scene scene = joined({own, look(mirrored(target.markers_T), noise.pose(), 10, 0, noise)});
    ConstellationSearch search = searchFor({target.markers_T});
    const auto& result = search.run(asCloud(scene.points_C))[0];
    ASSERT_EQ(result.verdict, SearchVerdict::kFound);
    EXPECT_LT((result.best.X_CT.translation() - X_CT.translation()).norm(), 0.0015);
  }
}

TEST(ConstellationSearch, ASymmetricTargetIsAmbiguous) {
  const Markers square{{0.04, 0.04, 0}, {-0.04, 0.04, 0}, {-0.04, -0.04, 0}, {0.04, -0.04, 0}, {0, 0, 0.03}};
  Noise noise(9);
  const RigidTransform X_CT = noise.pose();
  const Scene scene = look(square, X_CT, 5, 6, noise);
  ConstellationSearch search = searchFor({square});
  const auto& result = search.run(asCloud(scene.points_C))[0];
  EXPECT_EQ(result.verdict, SearchVerdict::kAmbiguous);
  EXPECT_EQ(result.best.matched, 5);
  EXPECT_EQ(result.runner_up.matched, 5);
  EXPECT_GT(angleBetween(result.best.X_CT, result.runner_up.X_CT), 80.0 * kDegree);
}

TEST(ConstellationSearch, OneMarkerOffTheSymmetryDecides) {
  const Markers kite{{0.04, 0.04, 0},  {-0.04, 0.04, 0}, {-0.04, -0.04, 0},
                     {0.04, -0.04, 0}, {0, 0, 0.03},     {0.03, 0.01, 0.02}};
  Noise noise(10);
  for (int trial = 0; trial < 100; ++trial) {
    const RigidTransform X_CT = noise.pose();
    const Scene all = look(kite, X_CT, 6, 4, noise);
    ConstellationSearch search = searchFor({kite});
    const auto& result = search.run(asCloud(all.points_C))[0];
    ASSERT_EQ(result.verdict, SearchVerdict::kFound);
    EXPECT_TRUE(isRight(result, all, X_CT));
    EXPECT_EQ(result.runner_up.matched, 5);
  }
}

TEST(ConstellationSearch, ANearlySymmetricToolIsAmbiguousWhereItsMarkersAreLoose) {
  const Markers tool = toolMarkers("P4_001.rom");
  if (tool.empty()) GTEST_SKIP() << "no shared data";
  Noise noise(11);
  EXPECT_EQ(verdictOn(tool, look(tool, noise.pose(), 4, 0, noise)), SearchVerdict::kFound);
  ConstellationSearch search = searchFor({tool}, {.tolerance_m = 0.005, .max_chance = 0.02});
  int ambiguous = 0;
  for (int trial = 0; trial < 100; ++trial) {
    Markers loose = tool;
    for (auto& p : loose) p += noise.gaussian(0.0015);
    const RigidTransform X_CT = noise.pose();
    const auto& result = search.run(asCloud(look(loose, X_CT, 4, 0, noise).points_C))[0];
    if (result.verdict == SearchVerdict::kAmbiguous) ++ambiguous;
    if (result.verdict != SearchVerdict::kFound) continue;
    EXPECT_LT(angleBetween(result.best.X_CT, X_CT), 15.0 * kDegree) << trial;
  }
  EXPECT_GT(ambiguous, 30);
}

TEST(ConstellationSearch, MarkersOnALineAreRefused) {
  const Markers tool = toolMarkers("8700248.rom");
  if (tool.empty()) GTEST_SKIP() << "no shared data";
  Noise noise(12);
  EXPECT_EQ(verdictOn(tool, look(tool, noise.pose(), 3, 0, noise)), SearchVerdict::kTooFewMarkers);
}

TEST(ConstellationSearch, AToolOfThreeMarkersNeedsToBeAlone) {
  const Markers tool = toolMarkers("P3_TraxisTA1D3.rom");
  if (tool.empty()) GTEST_SKIP() << "no shared data";
  Noise noise(13);
  EXPECT_EQ(verdictOn(tool, look(tool, noise.pose(), 3, 0, noise)), SearchVerdict::kFound);
  EXPECT_NE(verdictOn(tool, look(tool, noise.pose(), 3, 10, noise)), SearchVerdict::kFound);
}

TEST(ConstellationSearch, TargetsThatLookAlikeAreAmbiguous) {
  const Target target = forearm();
  Markers twin = target.markers_T;
  twin[3].x() += 0.0001;
  Noise noise(14);
  const Scene scene = look(target.markers_T, noise.pose(), 8, 4, noise);
  ConstellationSearch search = searchFor({target.markers_T, twin});
  for (const SearchResult& result : search.run(asCloud(scene.points_C)))
    EXPECT_EQ(result.verdict, SearchVerdict::kAmbiguous);
}

TEST(ConstellationSearch, OfTargetsThatShareAPartEachGetsItsOwnPoints) {
  const Target target = forearm();
  Markers cousin = target.markers_T;
  for (std::size_t i = 6; i < 10; ++i) cousin[i] += Vector3d(0.004, 0.009, -0.006);
  Noise noise(15);
  for (int trial = 0; trial < 100; ++trial) {
    const RigidTransform X_CT = noise.pose(), X_CU = noise.pose();
    const Scene first = look(target.markers_T, X_CT, 10, 0, noise), second = look(cousin, X_CU, 5, 0, noise);
    ConstellationSearch search = searchFor({cousin, target.markers_T});
    const auto results = search.run(asCloud(joined({first, second}).points_C));
    ASSERT_EQ(results[1].verdict, SearchVerdict::kFound);
    EXPECT_TRUE(isRight(results[1], first, X_CT));
    if (results[0].verdict != SearchVerdict::kFound) continue;
    EXPECT_LT((results[0].best.X_CT.translation() - X_CU.translation()).norm(), 0.003);
  }
}

TEST(ConstellationSearch, GeometryDecidesBetweenPointsThatShareADisc) {
  const Target target = forearm();
  Noise noise(16);
  for (int trial = 0; trial < 200; ++trial) {
    const RigidTransform X_CT = noise.pose();
    Scene scene = look(target.markers_T, X_CT, 7, 3, noise);
    auto cloud = asCloud(scene.points_C);
    for (int i = 0; i < 10; ++i) {
      cloud[static_cast<std::size_t>(i)].discs = {i, i};
      const CloudPoint real = cloud[static_cast<std::size_t>(i)];
      // Rivals on the left ray: paired with the right disc of another.
      for (const double along : {-0.02, 0.0015, 0.03}) {
        CloudPoint rival = real;
        rival.p_C *= 1.0 + along / real.p_C.norm();
        rival.discs.right = (i + 1) % 10;
        cloud.push_back(rival);
      }
    }
    ConstellationSearch search = searchFor({target.markers_T});
    const auto& result = search.run(cloud)[0];
    ASSERT_EQ(result.verdict, SearchVerdict::kFound);
    for (const int point : result.best.point_of_marker) EXPECT_LT(point, 10);
    EXPECT_TRUE(isRight(result, scene, X_CT));
  }
}

TEST(ConstellationSearch, OnlyWantedTargetsAreSought) {
  const Target target = forearm();
  Noise noise(17);
  const Scene scene = look(target.markers_T, noise.pose(), 10, 0, noise);
  ConstellationSearch search = searchFor({target.markers_T, target.markers_T});
  const auto results = search.run(asCloud(scene.points_C), std::vector<char>{0, 1});
  EXPECT_EQ(results[0].verdict, SearchVerdict::kTooFewMarkers);
  EXPECT_EQ(results[0].best.matched, 0);
  EXPECT_EQ(results[1].verdict, SearchVerdict::kFound);
}

TEST(ConstellationSearch, AnswersWhateverATargetOrCloudLacks) {
  const Target target = forearm();
  Noise noise(18);
  const Scene scene = look(target.markers_T, noise.pose(), 10, 0, noise);
  ConstellationSearch search = searchFor({target.markers_T, {}, {Vector3d(0, 0, 0), Vector3d(0.1, 0, 0)}});
  for (const SearchResult& result : search.run({})) EXPECT_EQ(result.verdict, SearchVerdict::kTooFewMarkers);
  EXPECT_EQ(search.run(asCloud({scene.points_C[0]}))[0].verdict, SearchVerdict::kTooFewMarkers);
  const auto results = search.run(asCloud(scene.points_C));
  EXPECT_EQ(results[0].verdict, SearchVerdict::kFound);
  EXPECT_EQ(results[1].verdict, SearchVerdict::kTooFewMarkers);
  EXPECT_EQ(results[2].verdict, SearchVerdict::kTooFewMarkers);
  EXPECT_TRUE(ConstellationSearch().run(asCloud(scene.points_C)).empty());
}

TEST(ConstellationSearch, APointWithoutCovarianceIsNotTakenForExact) {
  const Target target = forearm();
  Noise noise(19);
  auto cloud = asCloud(look(target.markers_T, noise.pose(), 10, 5, noise).points_C);
  for (auto& point : cloud) point.covariance_m2.setZero();
  EXPECT_EQ(searchFor({target.markers_T}).run(cloud)[0].best.matched, 10);
}

TEST(ConstellationSearch, CopiesGridsAndCrowdsEndInTime) {
  const Target target = forearm();
  Markers grid_like;
  std::vector<Vector3d> copies(40, Vector3d(0, 0, 0.5)), grid, crowd;
  for (int i = 0; i < 128; ++i) grid.emplace_back(0.02 * (i % 5), 0.02 * (i / 5 % 5), 0.4 + 0.02 * (i / 25));
  for (int i = 0; i < 64; ++i) grid_like.emplace_back(0.02 * (i % 4), 0.02 * (i / 4 % 4), 0.02 * (i / 16));
  Noise noise(20);
  for (int i = 0; i < 10'000; ++i) crowd.push_back(noise.stranger({0, 0, 0.5}));
  for (const auto& p : look(target.markers_T, noise.pose(), 10, 0, noise).points_C)
    copies.insert(copies.end(), 8, p);
  ConstellationSearch search = searchFor({target.markers_T, grid_like});
  EXPECT_EQ(search.run(asCloud(copies))[0].best.matched, 10);
  EXPECT_NE(search.run(asCloud(grid))[1].verdict, SearchVerdict::kFound);
  EXPECT_NE(search.run(asCloud(crowd))[0].verdict, SearchVerdict::kFound);
}

TEST(ConstellationSearch, StepsBoundTheSearch) {
  const Target target = forearm();
  Noise noise(21);
  const Scene scene = look(target.markers_T, noise.pose(), 6, 60, noise);
  EXPECT_EQ(verdictOn(target.markers_T, scene), SearchVerdict::kFound);
  EXPECT_EQ(verdictOn(target.markers_T, scene, {.max_steps = 20}), SearchVerdict::kCutOff);
}

TEST(ConstellationSearch, TakesNothingFromTheHeapOnceWarm) {
  if (!mirrorarm::testing::heapIsCounted) GTEST_SKIP() << "a sanitizer counts for itself";
  const Target target = forearm();
  Noise noise(22);
  const std::vector<Markers> targets{target.markers_T, randomMarkers(10, 0.07, noise)};
  std::vector<std::vector<CloudPoint>> clouds;
  for (int i = 0; i < 40; ++i)
    clouds.push_back(asCloud(joined({look(targets[0], noise.pose(), 5 + i % 6, 20, noise),
                                     look(targets[1], noise.pose(), 4 + i % 7, 10, noise)})
                                 .points_C));
  ConstellationSearch search = searchFor(targets);
  for (const auto& cloud : clouds) (void)search.run(cloud);
  EXPECT_EQ(mirrorarm::testing::heapCallsIn([&] {
              for (const auto& cloud : clouds) (void)search.run(cloud);
            }),
            0U);
}
