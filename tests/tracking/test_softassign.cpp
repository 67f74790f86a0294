#include <gtest/gtest.h>

#include "core/tracking/match_matrix.h"
#include "core/tracking/softassign.h"
#include "tests/tracking/world.h"

using namespace mirrorarm;
using namespace mirrorarm::tracking;
using namespace mirrorarm::tracking::test;

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

int countWrong(const std::vector<int>& y_of_x, const Scene& scene) {
  int wrong = 0;
  for (std::size_t j = 0; j < y_of_x.size(); ++j)
    if (y_of_x[j] >= 0 && scene.marker_of_point[static_cast<std::size_t>(y_of_x[j])] != static_cast<int>(j))
      ++wrong;
  return wrong;
}

}  // namespace

TEST(Softassign, ThePapersScheduleFindsTheArmFromAStartNearIt) {
  const Target target = forearm();
  Noise noise(1);
  for (int trial = 0; trial < 20; ++trial) {
    const RigidTransform X_CT = noise.pose();
    const Scene scene = look(target.markers_T, X_CT, 10, 0, noise);
    const auto found =
        registerSoftassign(target.markers_T, scene.points_C, {}, X_CT * noise.nudge(15 * kDegree, 0.02));
    EXPECT_EQ(found.matched, 10);
    EXPECT_EQ(countWrong(found.y_of_x, scene), 0);
    EXPECT_LT((found.X_YX.translation() - X_CT.translation()).norm(), 0.0003);
    EXPECT_LT(angleBetween(found.X_YX, X_CT), 0.3 * kDegree);
    EXPECT_LT(found.rms_m, 0.0005);
  }
}

TEST(Softassign, ABetaThatSuitsTheStartHoldsHalfTheMarkersAmongStrangers) {
  const Target target = forearm();
  SoftassignSettings near;
  near.beta_start = 1.0 / (2.0 * 8.0 * 8.0);
  near.beta_factor = 1.5;
  Noise noise(2);
  int right = 0;
  constexpr int kTrials = 200;
  for (int trial = 0; trial < kTrials; ++trial) {
    const RigidTransform X_CT = noise.pose();
    const Scene scene = look(target.markers_T, X_CT, 5, 5, noise);
    const auto found =
        registerSoftassign(target.markers_T, scene.points_C, near, X_CT * noise.nudge(4 * kDegree, 0.004));
    if (found.matched == 5 && countWrong(found.y_of_x, scene) == 0) ++right;
  }
  EXPECT_GE(right, kTrials * 98 / 100);
}

TEST(Softassign, PointsWithoutPartnerStayAlone) {
  const Target target = forearm();
  Noise noise(3);
  const Scene scene = look(target.markers_T, RigidTransform::Identity(), 7, 3, noise);
  SoftassignSettings near;
  near.beta_start = 0.01;
  const auto found = registerSoftassign(target.markers_T, scene.points_C, near, RigidTransform::Identity());
  EXPECT_EQ(found.matched, 7);
  EXPECT_EQ(countWrong(found.y_of_x, scene), 0);
}

TEST(Softassign, EmptyCloudsGiveNoMatch) {
  const Target target = forearm();
  EXPECT_EQ(registerSoftassign(target.markers_T, {}, {}).matched, 0);
  EXPECT_EQ(registerSoftassign({}, target.markers_T, {}).matched, 0);
}

TEST(Softassign, OnePointAndEqualPointsDoNoHarm) {
  const std::vector<Vector3d> one{Vector3d(0.1, 0.2, 0.3)};
  const auto alone = registerSoftassign(one, one, {});
  EXPECT_EQ(alone.matched, 1);
  EXPECT_TRUE(isRigid(alone.X_YX));

  const std::vector<Vector3d> equal(5, Vector3d(0.0, 0.0, 0.5));
  const auto doubled = registerSoftassign(forearm().markers_T, equal, {});
  EXPECT_TRUE(isRigid(doubled.X_YX));
  EXPECT_LE(doubled.matched, 5);
}

TEST(MatchMatrix, RowsAndColumnsWithTheirSlacksSumToOne) {
  Noise noise(4);
  for (const double beta : {1e-4, 1e-2, 1.0, 1e3}) {
    Eigen::ArrayXXd Q(6, 8);
    for (Eigen::Index i = 0; i < Q.size(); ++i) Q(i) = noise.uniform(-9.0, 400.0);
    MatchMatrix match;
    match.reset(6, 8);
    match.assign(Q, beta);
    ASSERT_TRUE(match.weights().allFinite());
    const Eigen::ArrayXd rows = match.weights().rowwise().sum().array() + match.slack();
    EXPECT_LT((rows - 1.0).abs().maxCoeff(), 1e-3) << beta;
    EXPECT_LE(match.weights().colwise().sum().maxCoeff(), 1.0 + 1e-9) << beta;
  }
}

TEST(MatchMatrix, HardensToAPermutation) {
  Eigen::ArrayXXd Q(3, 3);
  Q << 4.0, -9.0, 50.0,  //
      -8.0, 2.0, 30.0,   //
      80.0, 90.0, 70.0;
  MatchMatrix match;
  match.reset(3, 3);
  match.assign(Q, 1e3);
  EXPECT_TRUE(match.isBinary(1e-6));
  EXPECT_NEAR(match.weights()(0, 1), 1.0, 1e-6);
  EXPECT_NEAR(match.weights()(1, 0), 1.0, 1e-6);
  EXPECT_NEAR(match.slack()[2], 1.0, 1e-6);
}
