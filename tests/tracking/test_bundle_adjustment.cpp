#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "core/geometry/rigid_fit.h"
#include "core/tracking/bundle_adjustment.h"
#include "tests/tracking/world.h"

using namespace mirrorarm;
using namespace mirrorarm::tracking;
using namespace mirrorarm::tracking::test;

namespace {

/// As a stereo rig measures at 0.4 m: long in depth.
const Vector3d kSigmas_m(0.000013, 0.000014, 0.000071);

struct Lesson {
  int frames = 100;
  int seen = 10;  ///< markers a frame
  Vector3d sigmas_m = kSigmas_m;
  bool known = true;                ///< sensor's covariance
  double start_error_m = 0.0005;    ///< of markers and poses
  std::vector<double> skin_m = {};  ///< per marker
};

MarkerNetwork measured(const Target& truth, const Lesson& lesson, Noise& noise) {
  MarkerNetwork network;
  for (const auto& p : truth.markers_T) network.markers_T.push_back(p + noise.gaussian(lesson.start_error_m));
  network.spread_m.assign(truth.markers_T.size(), -1.0);
  const RigidTransform middle = noise.pose();
  for (int f = 0; f < lesson.frames; ++f) {
    const RigidTransform X_CT = middle * noise.nudge(0.4, 0.05);
    NetworkFrame frame{X_CT * noise.nudge(0.01, lesson.start_error_m), {}};
    std::vector<int> order(truth.markers_T.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
    std::shuffle(order.begin(), order.end(), noise.rng);
    order.resize(static_cast<std::size_t>(lesson.seen));
    for (const int marker : order) {
      const auto i = static_cast<std::size_t>(marker);
      Vector3d p_T = truth.markers_T[i];
      if (!lesson.skin_m.empty()) p_T += noise.gaussian(lesson.skin_m[i]);
      const Vector3d p_C = X_CT * p_T + lesson.sigmas_m.cwiseProduct(noise.gaussian(1.0));
      Sighting sighting{marker, p_C, Eigen::Matrix3d::Zero()};
      if (lesson.known) sighting.covariance_m2 = lesson.sigmas_m.cwiseAbs2().asDiagonal();
      frame.sightings.push_back(sighting);
    }
    network.frames.push_back(frame);
  }
  return network;
}

/// Adjusted markers less true ones, once the two are laid on each other.
Eigen::VectorXd errors(const MarkerNetwork& network, const Target& truth) {
  const RigidTransform X = fitByKabsch(truth.markers_T, network.markers_T);
  Eigen::VectorXd e(3 * static_cast<Eigen::Index>(truth.markers_T.size()));
  for (std::size_t i = 0; i < truth.markers_T.size(); ++i)
    e.segment<3>(3 * static_cast<Eigen::Index>(i)) =
        X.linear().transpose() * (network.markers_T[i] - X * truth.markers_T[i]);
  return e;
}

Eigen::MatrixXd pseudoInverse(const Eigen::MatrixXd& covariance) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(covariance);
  Eigen::VectorXd inverse = solver.eigenvalues();
  inverse.head<6>().setZero();
  inverse.tail(inverse.size() - 6) = inverse.tail(inverse.size() - 6).cwiseInverse();
  return solver.eigenvectors() * inverse.asDiagonal() * solver.eigenvectors().transpose();
}

double rms(const Eigen::VectorXd& e) { return std::sqrt(e.squaredNorm() / static_cast<double>(e.size())); }

}  // namespace

TEST(BundleAdjustment, FindsTheShapeWithAnHonestCovariance) {
  const Target truth = forearm();
  double nees = 0.0, spread = 0.0;
  constexpr int kLessons = 30;
  for (int lesson = 0; lesson < kLessons; ++lesson) {
    Noise noise(200 + static_cast<unsigned>(lesson));
    MarkerNetwork network = measured(truth, {.frames = 60, .seen = 7}, noise);
    BundleAdjustment bundle;
    bundle.adjust(network);
    const Eigen::VectorXd e = errors(network, truth);
    EXPECT_LT(rms(e), 0.00001);
    nees += e.dot(pseudoInverse(bundle.covariance_m2()) * e) / kLessons;
    for (const double s : network.spread_m) spread = std::max(spread, s);
    EXPECT_NEAR(bundle.chi2() / bundle.freedom(), 1.0, 0.12);
  }
  // 24 degrees of freedom: its mean over 30 lessons has a standard deviation of 1.26.
  EXPECT_NEAR(nees, 24.0, 3.8);
  EXPECT_LT(spread, 0.00001);
}

TEST(BundleAdjustment, TheGaugeIsThatOfTheStart) {
  const Target truth = forearm();
  Noise noise(240);
  MarkerNetwork network = measured(truth, {.frames = 20}, noise);
  const auto start_T = network.markers_T;
  BundleAdjustment bundle;
  bundle.adjust(network);
  const RigidTransform X = fitByKabsch(start_T, network.markers_T);
  EXPECT_LT(X.translation().norm(), 2e-6);
  EXPECT_LT(angleBetween(X, RigidTransform::Identity()), 2e-5);
  // Six motions are left free.
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(bundle.covariance_m2());
  EXPECT_LT(std::abs(solver.eigenvalues()[5]), 1e-6 * solver.eigenvalues()[6]);
  EXPECT_GT(solver.eigenvalues()[6], 0.0);
}

TEST(BundleAdjustment, GrossErrorsDoNotCount) {
  const Target truth = forearm();
  Noise noise(241);
  MarkerNetwork network = measured(truth, {.frames = 60}, noise);
  for (std::size_t f = 0; f < network.frames.size(); f += 2)
    network.frames[f].sightings[f % 10].point_C += noise.gaussian(0.003);
  BundleAdjustment bundle;
  bundle.adjust(network);
  EXPECT_LT(rms(errors(network, truth)), 0.00001);
}

TEST(BundleAdjustment, TellsWhichMarkersMoveOnSkin) {
  const Target truth = forearm();
  Noise noise(242);
  Lesson lesson{.frames = 100};
  lesson.skin_m.assign(10, 0.0);
  lesson.skin_m[3] = 0.0008;
  lesson.skin_m[7] = 0.0002;
  MarkerNetwork network = measured(truth, lesson, noise);
  BundleAdjustment bundle;
  bundle.adjust(network);
  for (std::size_t i = 0; i < 10; ++i)
    EXPECT_NEAR(network.spread_m[i], lesson.skin_m[i], 0.00001 + 0.2 * lesson.skin_m[i]);
  const Eigen::VectorXd e = errors(network, truth);
  for (std::size_t i = 0; i < 10; ++i) {
    const Vector3d own = e.segment<3>(3 * static_cast<Eigen::Index>(i));
    EXPECT_LT(own.dot(bundle.covarianceOf(i).inverse() * own), 20.0) << i;
    if (lesson.skin_m[i] == 0.0) {
      EXPECT_LT(own.norm(), 0.0001);
    }
  }
}

TEST(BundleAdjustment, WithoutTheSensorsCovarianceResidualsTell) {
  const Target truth = forearm();
  constexpr double kEven_m = 0.00005;
  Noise noise(243);
  MarkerNetwork network =
      measured(truth, {.frames = 100, .sigmas_m = Vector3d::Constant(kEven_m), .known = false}, noise);
  BundleAdjustment bundle;
  bundle.adjust(network);
  for (const double spread : network.spread_m) EXPECT_NEAR(spread, kEven_m, 0.25 * kEven_m);
  EXPECT_LT(rms(errors(network, truth)), 0.00001);
}

TEST(BundleAdjustment, ASwayThatLastsLeavesAMarkerLessSure) {
  const Target truth = forearm();
  Noise noise(244);
  MarkerNetwork still = measured(truth, {.frames = 100}, noise);
  MarkerNetwork swaying = still;
  MarkerNetwork shaking = still;
  for (std::size_t f = 0; f < 100; ++f) {
    const double phase = 2.0 * std::numbers::pi * static_cast<double>(f);
    for (auto& s : swaying.frames[f].sightings)
      if (s.marker == 4) s.point_C.x() += 0.001 * std::sin(phase / 50.0);
    for (auto& s : shaking.frames[f].sightings)
      if (s.marker == 4) s.point_C.x() += 0.001 * std::sin(phase * 0.381);
  }
  BundleAdjustment a, b;
  a.adjust(swaying);
  b.adjust(shaking);
  EXPECT_GT(a.covarianceOf(4).trace(), 4.0 * b.covarianceOf(4).trace());
}

TEST(BundleAdjustment, OneFrameAndFramesWithTooLittleDoNoHarm) {
  const Target truth = forearm();
  Noise noise(245);
  MarkerNetwork network = measured(truth, {.frames = 1}, noise);
  network.frames.push_back({noise.pose(), {network.frames[0].sightings[0], network.frames[0].sightings[1]}});
  network.frames.push_back({noise.pose(), {}});
  BundleAdjustment bundle;
  bundle.adjust(network);
  EXPECT_EQ(bundle.freedom(), 0);
  EXPECT_LT(rms(errors(network, truth)), 0.0001);
  EXPECT_TRUE(bundle.covariance_m2().allFinite());
}

TEST(BundleAdjustment, NoMarkerOfAnUnknownSensorTakesThePosesForItself) {
  const Target truth = forearm();
  for (unsigned lesson = 0; lesson < 20; ++lesson) {
    Noise noise(250 + lesson);
    MarkerNetwork network = measured(truth, {.frames = 12, .seen = 6, .known = false}, noise);
    BundleAdjustment bundle;
    bundle.adjust(network);
    EXPECT_LT(rms(errors(network, truth)), 0.00005);
    for (std::size_t i = 0; i < 10; ++i) {
      EXPECT_GT(network.spread_m[i], 0.000005);
      EXPECT_LT(std::sqrt(bundle.covarianceOf(i).trace()), 0.0001);
    }
  }
}

TEST(BundleAdjustment, GoesOnFromSpreadsThatAreFarTooSmall) {
  const Target truth = forearm();
  for (const bool known : {true, false}) {
    Noise noise(270);
    MarkerNetwork network =
        measured(truth, {.frames = 60, .sigmas_m = Vector3d::Constant(0.00005), .known = known}, noise);
    network.spread_m.assign(10, 0.000001);
    BundleAdjustment bundle;
    bundle.adjust(network);
    EXPECT_LT(rms(errors(network, truth)), 0.00002);
    for (std::size_t i = 0; i < 10; ++i) {
      EXPECT_GT(std::sqrt(bundle.covarianceOf(i).trace()), 0.000005);
      EXPECT_LT(std::sqrt(bundle.covarianceOf(i).trace()), 0.00003);
    }
  }
}
