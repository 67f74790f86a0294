#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "core/geometry/rigid_fit.h"
#include "core/tracking/pose_estimator.h"
#include "tests/common/no_heap.h"
#include "tests/tracking/stereo_sight.h"

namespace mirrorarm::tracking::test {
namespace {

using Matrix6d = Eigen::Matrix<double, 6, 6>;
using Vector6d = Eigen::Matrix<double, 6, 1>;

constexpr double kPixelNoise_px = 0.02;

/// About 400 mm away, turned by up to 40 degrees.
RigidTransform poseBefore(Noise& noise) {
  const Eigen::AngleAxisd turn(noise.uniform(0.0, 0.7), noise.gaussian(1.0).normalized());
  return makeTransform(Eigen::Quaterniond(turn),
                       Vector3d(0.06 + noise.uniform(-0.03, 0.03), noise.uniform(-0.03, 0.03),
                                0.4 + noise.uniform(-0.02, 0.02)));
}

RigidTransform moved(const RigidTransform& X, const Vector6d& d) {
  const double angle = d.head<3>().norm();
  const Vector3d axis = angle > 0.0 ? Vector3d(d.head<3>() / angle) : Vector3d::UnitX();
  return X * makeTransform(Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis)), d.tail<3>());
}

/// The four pixel coordinates of every marker, each divided by its standard deviation, minus the measured.
Eigen::VectorXd pixelMisfit(const camera::StereoRig& rig, const std::vector<SeenMarker>& seen,
                            const RigidTransform& X_CT) {
  Eigen::VectorXd misfit(4 * static_cast<Eigen::Index>(seen.size()));
  Eigen::Index row = 0;
  const auto add = [&](const vision::DetectedMarker& marker, const Eigen::Vector2d& projected) {
    const Eigen::Matrix2d whiten = Eigen::Matrix2d(marker.covariance_px2.llt().matrixL()).inverse();
    misfit.segment<2>(row) = whiten * (projected - marker.centre_px);
    row += 2;
  };
  for (const auto& marker : seen) {
    const Vector3d p_C = X_CT * marker.match.marker_T;
    add(marker.left, *rig.left.project(p_C));
    add(marker.right, *rig.right.project(rig.X_RC * p_C));
  }
  return misfit;
}

struct PixelFit {
  RigidTransform X_CT;
  Matrix6d covariance;
};

/// The pose of least reprojection error in both images, derivatives by differences: nothing of the product's
/// estimator.
PixelFit fitPixels(const camera::StereoRig& rig, const std::vector<SeenMarker>& seen, RigidTransform X_CT) {
  constexpr double kStep = 1e-6;
  Eigen::MatrixXd J(4 * static_cast<Eigen::Index>(seen.size()), 6);
  Matrix6d covariance;
  for (int round = 0; round < 20; ++round) {
    for (int k = 0; k < 6; ++k) {
      const Vector6d d = kStep * Vector6d::Unit(k);
      J.col(k) =
          (pixelMisfit(rig, seen, moved(X_CT, d)) - pixelMisfit(rig, seen, moved(X_CT, -d))) / (2.0 * kStep);
    }
    covariance = Matrix6d(J.transpose() * J).inverse();
    X_CT = moved(X_CT, -covariance * (J.transpose() * pixelMisfit(rig, seen, X_CT)));
  }
  return {X_CT, covariance};
}

/// Deviates of a marker's model that no covariance tells.
std::vector<Vector3d> deformed(const std::vector<Vector3d>& markers_T, double sigma_m, Noise& noise) {
  auto moved = markers_T;
  for (auto& marker : moved) marker += noise.gaussian(sigma_m);
  return moved;
}

/// Mean of e' C^-1 e over `trials` poses; the world looks different from what the model says by `deform`.
double meanNees(int trials, double sigma_px, double deform_m) {
  Noise noise(20);
  const auto rig = fisheyeRig();
  const auto target = forearm();
  PoseEstimator estimator;
  double sum = 0.0;
  for (int i = 0; i < trials; ++i) {
    const RigidTransform X_CT = poseBefore(noise);
    auto matches = matchesOf(sight(rig, deformed(target.markers_T, deform_m, noise), X_CT, sigma_px, noise));
    for (std::size_t m = 0; m < matches.size(); ++m) matches[m].marker_T = target.markers_T[m];
    const auto& estimate = estimator.estimate(matches, X_CT * noise.nudge(0.05, 0.005));
    sum += squaredSigmas(estimate.X_CT, estimate.covariance, X_CT);
  }
  return sum / trials;
}

TEST(PoseEstimator, EqualsTheFullMinimisationOfThePixels) {
  Noise noise(1);
  const auto rig = fisheyeRig();
  const auto target = forearm();
  PoseEstimator estimator;
  for (int i = 0; i < 50; ++i) {
    const RigidTransform X_CT = poseBefore(noise);
    const auto seen = sight(rig, target.markers_T, X_CT, kPixelNoise_px, noise);
    // Without Huber's weights, which the pixels' fit has not.
    const auto estimate =
        PoseEstimator({.huber_sigmas = 6.0, .outlier_sigmas = 8.0}).estimate(matchesOf(seen), X_CT);
    if (estimate.excess_m > 0.0) continue;  // one in a thousand by design
    const auto pixels = fitPixels(rig, seen, X_CT);
    EXPECT_LT(squaredSigmas(estimate.X_CT, pixels.covariance, pixels.X_CT), 0.02 * 0.02);
    const Eigen::GeneralizedSelfAdjointEigenSolver<Matrix6d> ratio(estimate.covariance, pixels.covariance);
    EXPECT_NEAR(ratio.eigenvalues().minCoeff(), 1.0, 0.01);
    EXPECT_NEAR(ratio.eigenvalues().maxCoeff(), 1.0, 0.01);
  }
}

// Chi-square of 6 degrees over 3000 poses: its mean lies within 6 +- 0.163 in 99 of 100 cases.
TEST(PoseEstimator, CovarianceOfARigidTargetTellsTheTruth) {
  EXPECT_NEAR(meanNees(3000, kPixelNoise_px, 0.0), 6.0, 0.163);
}

TEST(PoseEstimator, MisfitTellsTheCovarianceOfAnUnknownSensor) {
  Noise noise(2);
  const auto target = forearm();
  PoseEstimator estimator;
  double sum = 0.0;
  for (int i = 0; i < 1500; ++i) {
    const RigidTransform X_CT = noise.pose();
    std::vector<MarkerMatch> matches(target.markers_T.size());
    for (std::size_t m = 0; m < matches.size(); ++m) {
      matches[m].marker_T = target.markers_T[m];
      matches[m].point_C = X_CT * target.markers_T[m] + noise.gaussian(0.0001);
    }
    const auto& estimate = estimator.estimate(matches, X_CT * noise.nudge(0.05, 0.005));
    sum += squaredSigmas(estimate.X_CT, estimate.covariance, X_CT);
  }
  EXPECT_NEAR(sum / 1500.0, 6.0, 0.3);
}

TEST(PoseEstimator, CovarianceWidensOnABodyThatDeforms) {
  for (const double deform_m : {0.0001, 0.0003, 0.001, 0.003}) {
    const double nees = meanNees(500, kPixelNoise_px, deform_m);
    EXPECT_GT(nees, 5.0) << deform_m;
    EXPECT_LT(nees, 7.5) << deform_m;
  }
}

TEST(PoseEstimator, UnknownSensorGivesKabschsPose) {
  Noise noise(3);
  const auto target = forearm();
  const RigidTransform X_CT = noise.pose();
  std::vector<MarkerMatch> matches;
  std::vector<Vector3d> points_C;
  for (const auto& marker_T : target.markers_T) {
    points_C.push_back(X_CT * marker_T + noise.gaussian(0.0001));
    matches.push_back({marker_T, Eigen::Matrix3d::Zero(), points_C.back(), Eigen::Matrix3d::Zero()});
  }
  PoseEstimator estimator({.huber_sigmas = 10.0, .outlier_sigmas = 20.0});
  const auto& estimate = estimator.estimate(matches, X_CT);
  EXPECT_LT(errorOf(estimate.X_CT, fitByKabsch(target.markers_T, points_C)).norm(), 1e-7);
  EXPECT_NEAR(estimate.excess_m, 0.0001, 0.00003);
}

TEST(PoseEstimator, ExactMatchesGiveTheExactPose) {
  Noise noise(4);
  const RigidTransform X_CT = noise.pose();
  std::vector<MarkerMatch> matches(3);
  for (std::size_t i = 0; i < 3; ++i) {
    matches[i].marker_T = forearm().markers_T[i];
    matches[i].point_C = X_CT * matches[i].marker_T;
  }
  PoseEstimator estimator;
  const auto& estimate = estimator.estimate(matches, X_CT * noise.nudge(0.3, 0.03));
  EXPECT_LT(errorOf(estimate.X_CT, X_CT).norm(), 1e-9);
  EXPECT_EQ(estimate.freedom, 3);
  EXPECT_TRUE(estimate.covariance.allFinite());
}

TEST(PoseEstimator, StartsFromAfarAndCutsOutliers) {
  Noise noise(5);
  const auto rig = fisheyeRig();
  const auto target = forearm();
  PoseEstimator estimator;
  for (int i = 0; i < 300; ++i) {
    const RigidTransform X_CT = poseBefore(noise);
    auto matches = matchesOf(sight(rig, target.markers_T, X_CT, kPixelNoise_px, noise));
    for (const std::size_t wrong : {5U, 8U}) matches[wrong].point_C += noise.gaussian(0.01);
    matches[1].point_C.y() += 0.004;
    const auto& estimate = estimator.estimate(matches, X_CT * noise.nudge(0.35, 0.02));
    EXPECT_LT(squaredSigmas(estimate.X_CT, estimate.covariance, X_CT), 40.0) << i;
    EXPECT_EQ(estimator.weights()[1], 0.0) << i;
    EXPECT_GT(estimator.weights()[2], 0.0) << i;
  }
}

TEST(PoseEstimator, MarkersOnALineLeaveTheirTurnUnknown) {
  std::vector<MarkerMatch> matches(4);
  for (std::size_t i = 0; i < 4; ++i) {
    matches[i].marker_T = Vector3d(0.05 * static_cast<double>(i), 0.0, 0.0);
    matches[i].point_C = matches[i].marker_T + Vector3d(0.0, 0.0, 0.4);
    matches[i].point_covariance_m2 = 1e-10 * Eigen::Matrix3d::Identity();
  }
  PoseEstimator estimator;
  const auto& estimate = estimator.estimate(
      matches, makeTransform(Eigen::Matrix3d(Eigen::Matrix3d::Identity()), Vector3d(0.0, 0.0, 0.4)));
  EXPECT_GT(std::sqrt(estimate.covariance(0, 0)), 1.0);
  EXPECT_LT(std::sqrt(estimate.covariance(1, 1)), 0.001);
}

TEST(PoseEstimator, TakesNothingFromTheHeap) {
  if (!mirrorarm::testing::heapIsCounted) GTEST_SKIP() << "a sanitizer brings its own heap";
  Noise noise(6);
  const RigidTransform X_CT = poseBefore(noise);
  const auto matches = matchesOf(sight(fisheyeRig(), forearm().markers_T, X_CT, kPixelNoise_px, noise));
  PoseEstimator estimator;
  (void)estimator.estimate(matches, X_CT);
  EXPECT_EQ(mirrorarm::testing::heapCallsIn([&] { (void)estimator.estimate(matches, X_CT); }), 0U);
}

}  // namespace
}  // namespace mirrorarm::tracking::test
