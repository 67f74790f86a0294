#include <gtest/gtest.h>

#include "core/tracking/warm_registration.h"
#include "tests/common/no_heap.h"
#include "tests/tracking/world.h"

using namespace mirrorarm;
using namespace mirrorarm::tracking;
using namespace mirrorarm::tracking::test;

namespace {

/// About where the target is: as sure as a few frames without it leave it.
UncertainPose about(const RigidTransform& X_CT, double turn_rad = 0.05, double shift_m = 0.005) {
  UncertainPose pose;
  pose.X_CT = X_CT;
  pose.covariance.diagonal().head<3>().setConstant(turn_rad * turn_rad);
  pose.covariance.diagonal().tail<3>().setConstant(shift_m * shift_m);
  return pose;
}

/// Matches of another marker's point, or of a stranger's.
int wrongMatches(const ShapeFit& fit, const Scene& scene) {
  int wrong = 0;
  for (std::size_t j = 0; j < fit.point_of_marker.size(); ++j)
    if (const int point = fit.point_of_marker[j]; point >= 0)
      wrong += scene.marker_of_point[static_cast<std::size_t>(point)] != static_cast<int>(j) ? 1 : 0;
  return wrong;
}

}  // namespace

TEST(WarmRegistration, FindsEachMarkerAmongStrangers) {
  const Target target = forearm();
  Noise noise(61);
  WarmRegistration registration;
  for (int trial = 0; trial < 500; ++trial) {
    const RigidTransform X_CT = noise.pose();
    const int visible = 4 + trial % 7;
    const Scene scene = look(target.markers_T, X_CT, visible, 8, noise);
    const auto& fit =
        registration.run({target.markers_T}, cloudOf(scene), about(X_CT * noise.nudge(0.08, 0.006)));
    ASSERT_EQ(fit.reason, LostReason::kNone) << trial;
    EXPECT_EQ(wrongMatches(fit, scene), 0) << trial;
    EXPECT_GE(fit.matched, visible - 1) << trial;
    EXPECT_LT((fit.pose.X_CT.translation() - X_CT.translation()).norm(), 0.0008);
  }
}

TEST(WarmRegistration, ThreeMarkersSufficeWhereTheyAreExpected) {
  const Target target = forearm();
  Noise noise(62);
  WarmRegistration registration;
  int found = 0;
  constexpr int kTrials = 300;
  for (int trial = 0; trial < kTrials; ++trial) {
    const RigidTransform X_CT = noise.pose();
    const Scene scene = look(target.markers_T, X_CT, 3, 0, noise);
    const auto& fit =
        registration.run({target.markers_T}, cloudOf(scene), about(X_CT * noise.nudge(0.03, 0.003)));
    if (fit.reason != LostReason::kNone) continue;
    ++found;
    EXPECT_EQ(wrongMatches(fit, scene), 0);
  }
  EXPECT_GE(found, kTrials * 97 / 100);
}

TEST(WarmRegistration, AStrangerBesideAHiddenMarkersPlaceIsNotTakenForIt) {
  const Target target = forearm();
  Noise noise(63);
  WarmRegistration registration;
  for (int trial = 0; trial < 200; ++trial) {
    const RigidTransform X_CT = noise.pose();
    Scene scene = look(target.markers_T, X_CT, 10, 0, noise);
    const auto hidden = static_cast<std::size_t>(trial) % 10;
    const Vector3d aside = noise.gaussian(1.0).normalized() * noise.uniform(0.002, 0.006);
    scene.points_C[hidden] += aside;
    scene.marker_of_point[hidden] = -1;
    const auto& fit =
        registration.run({target.markers_T}, cloudOf(scene), about(X_CT * noise.nudge(0.03, 0.003)));
    ASSERT_EQ(fit.reason, LostReason::kNone);
    EXPECT_EQ(wrongMatches(fit, scene), 0) << trial;
    EXPECT_EQ(fit.matched, 9);
  }
}

TEST(WarmRegistration, PointsThatShareADiscAreNotBothMatched) {
  const Target target = forearm();
  Noise noise(64);
  WarmRegistration registration;
  const RigidTransform X_CT = noise.pose();
  Scene scene = look(target.markers_T, X_CT, 10, 0, noise);
  auto cloud = cloudOf(scene);
  for (std::size_t i = 0; i < cloud.size(); ++i) cloud[i].discs = {static_cast<int>(i), static_cast<int>(i)};
  CloudPoint ghost = cloud[0];
  ghost.p_C *= 1.0008;
  ghost.discs.right = 99;
  cloud.push_back(ghost);
  const auto& fit = registration.run({target.markers_T}, cloud, about(X_CT));
  ASSERT_EQ(fit.reason, LostReason::kNone);
  EXPECT_EQ(fit.matched, 10);
  for (const int point : fit.point_of_marker) EXPECT_NE(point, 10);
}

TEST(WarmRegistration, SaysWhyNot) {
  const Target target = forearm();
  Noise noise(65);
  WarmRegistration registration;
  const RigidTransform X_CT = noise.pose();
  EXPECT_EQ(registration.run({target.markers_T}, {}, about(X_CT)).reason, LostReason::kNoPoints);
  const Scene two = look(target.markers_T, X_CT, 2, 0, noise);
  EXPECT_EQ(registration.run({target.markers_T}, cloudOf(two), about(X_CT)).reason,
            LostReason::kTooFewMarkers);
  std::vector<Vector3d> elsewhere = target.markers_T;
  for (auto& p : elsewhere) p += noise.gaussian(0.008);
  const Scene other = look(elsewhere, X_CT, 10, 0, noise);
  EXPECT_EQ(registration.run({target.markers_T}, cloudOf(other), about(X_CT)).reason, LostReason::kBadFit);
  const std::vector<Vector3d> line{{0, 0, 0}, {0.02, 0, 0}, {0.05, 0, 0}, {0.09, 0, 0}};
  const Scene on_line = look(line, X_CT, 4, 0, noise);
  EXPECT_EQ(registration.run({line}, cloudOf(on_line), about(X_CT)).reason, LostReason::kTooFewMarkers);
}

TEST(WarmRegistration, MarkersThatDoNotCountAreNotLookedFor) {
  const Target target = forearm();
  Noise noise(66);
  WarmRegistration registration;
  const RigidTransform X_CT = noise.pose();
  const Scene scene = look(target.markers_T, X_CT, 10, 0, noise);
  std::vector<char> present(10, 1);
  present[4] = 0;
  const auto& fit = registration.run({target.markers_T, {}, present}, cloudOf(scene), about(X_CT));
  ASSERT_EQ(fit.reason, LostReason::kNone);
  EXPECT_EQ(fit.matched, 9);
  EXPECT_EQ(fit.point_of_marker[4], -1);
}

TEST(WarmRegistration, TakesNothingFromTheHeapOnceItsBuffersHaveGrown) {
  if (!mirrorarm::testing::heapIsCounted) GTEST_SKIP() << "a sanitizer brings its own heap";
  const Target target = forearm();
  Noise noise(67);
  WarmRegistration registration;
  for (int frame = 0; frame < 60; ++frame) {
    const RigidTransform X_CT = noise.pose();
    const auto cloud = cloudOf(look(target.markers_T, X_CT, 10, 15, noise));
    const auto guess = about(X_CT * noise.nudge(0.05, 0.005));
    const auto calls =
        mirrorarm::testing::heapCallsIn([&] { (void)registration.run({target.markers_T}, cloud, guess); });
    ASSERT_TRUE(frame < 40 || calls == 0) << frame;
  }
}
