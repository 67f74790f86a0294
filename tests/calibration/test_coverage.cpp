#include <numbers>

#include <gtest/gtest.h>

#include "core/calibration/coverage.h"

namespace mirrorarm::calibration {
namespace {

constexpr ImageSize kSize{1000, 800};

TEST(Coverage, CountsThePointsWhereTheyLie) {
  BoardView view;
  view.seen[0] = sightingOf(std::vector<Eigen::Vector2d>{{-0.5, -0.5}, {5, 5}, {999.4, 799.4}, {550, 90}});
  view.seen[1] = sightingOf(std::vector<Eigen::Vector2d>{{-3.0, 10}, {500, 4000}});
  const auto coverage = coverageOf({&view, 1}, {}, kSize);
  EXPECT_EQ(coverage.image[0][0][0], 2);
  EXPECT_EQ(coverage.image[0][9][9], 1);
  EXPECT_EQ(coverage.image[0][1][5], 1);
  EXPECT_DOUBLE_EQ(coverage.imageShare(0), 0.03);
  EXPECT_DOUBLE_EQ(coverage.imageShare(1), 0.0);
  EXPECT_DOUBLE_EQ(coverage.poseShare(), 0.0);
}

/// The board's middle at `p_C`, its normal turned from the line of sight.
RigidTransform tilted(const Eigen::Vector3d& p_C, double tilt_rad, const Eigen::Vector3d& middle_M) {
  const Eigen::Vector3d sight = p_C.normalized();
  const Eigen::Quaterniond R = Eigen::AngleAxisd(tilt_rad, sight.unitOrthogonal()) *
                               Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), sight);
  return makeTransform(R, p_C - R * middle_M);
}

TEST(Coverage, TiltIsFromTheLineOfSightToTheMiddle) {
  const Eigen::Vector3d middle_M = boardMiddle(*boardOf("dots:9x7:0.03"));
  const double degree = std::numbers::pi / 180.0;
  const Eigen::Vector3d far_aside = 0.3 * Eigen::Vector3d(0.8, 0.0, 0.6), ahead(0.0, 0.0, 0.6);
  const std::vector<RigidTransform> X_CM = {
      tilted(far_aside, 10 * degree, middle_M), tilted(far_aside, 32 * degree, middle_M),
      tilted(ahead, 70 * degree, middle_M), tilted(3.0 * ahead, 5 * degree, middle_M)};
  const auto coverage = coverageOf({}, X_CM, kSize, {}, middle_M);
  EXPECT_EQ(coverage.pose[0][0], 1);
  EXPECT_EQ(coverage.pose[2][0], 1);
  EXPECT_EQ(coverage.pose[3][3], 1);
  EXPECT_DOUBLE_EQ(coverage.poseShare(), 3.0 / 16.0);
}

}  // namespace
}  // namespace mirrorarm::calibration
