#include <cmath>
#include <numbers>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "benchmarks/statistics.h"
#include "benchmarks/vision/disc.h"
#include "benchmarks/vision/information.h"
#include "benchmarks/vision/stereo_camera.h"
#include "core/vision/marker_finder.h"
#include "core/vision/stereo_vision.h"

// What `./dev bench vision` measures, with fewer trials and looser margins.
namespace mirrorarm::vision {
namespace {

using namespace benchmarks;
using namespace benchmarks::vision;

constexpr int kTrials = 200;
constexpr double kLeastRatio = 0.7;

/// What the finder made of many discs, one an image.
struct Limits {
  RootMeanSquare error_px, bound_px;
  double normalised = 0.0;  ///< sum of e' C^-1 e
  int found = 0, flagged = 0, good = 0, silent = 0;
};

template <class MakeDisc>
Limits look(double snr, std::uint64_t stream, MakeDisc make) {
  MarkerFinder finder{FinderSettings{}};
  Limits limits;
  for (std::uint64_t trial = 0; trial < kTrials; ++trial) {
    TrialRandom random(1, stream, trial);
    const Disc disc = make(random);
    const double sigma = disc.contrast / snr;
    const auto image = exposed(lightOf(disc), sigma, random);
    const Detection& seen = finder.find(image.view());
    limits.bound_px.addSquare(std::pow(centreBoundFormula(disc, sigma), 2));
    if (seen.markers.size() != 1) continue;
    const DetectedMarker& marker = seen.markers.front();
    const Eigen::Vector2d off = marker.centre_px - disc.centre_px;
    ++limits.found;
    limits.error_px.addSquare(off.squaredNorm(), 2);
    limits.normalised += off.dot(marker.covariance_px2.inverse() * off);
    limits.flagged += marker.cut ? 1 : 0;
    limits.good += !marker.cut && off.norm() <= 0.15 ? 1 : 0;
    limits.silent += !marker.cut && off.norm() > 0.3 ? 1 : 0;
  }
  return limits;
}

TEST(Limits, CentresAreNearTheCramerRaoBound) {
  for (const auto& [diameter_px, snr] :
       {std::pair{7.0, 100.0}, {10.0, 100.0}, {16.0, 100.0}, {24.0, 100.0}, {10.0, 40.0}}) {
    const Limits limits = look(snr, static_cast<std::uint64_t>(diameter_px + snr), [&](TrialRandom& random) {
      return randomDisc(diameter_px, kLeastRatio, random);
    });
    EXPECT_EQ(limits.found, kTrials) << diameter_px;
    EXPECT_LE(limits.error_px.value(), 1.35 * limits.bound_px.value()) << diameter_px << " " << snr;
    EXPECT_NEAR(limits.normalised / limits.found, 2.0, 0.7) << diameter_px << " " << snr;
    EXPECT_EQ(limits.flagged, 0) << diameter_px << " " << snr;
  }
}

TEST(Limits, RampHardlyMovesTheCentre) {
  constexpr double kDiameter_px = 10.0;
  const Limits limits = look(100.0, 1, [&](TrialRandom& random) {
    Disc disc = randomDisc(kDiameter_px, kLeastRatio, random);
    const double direction = random.uniform(0.0, 2.0 * std::numbers::pi);
    disc.slope = 0.2 / kDiameter_px * Eigen::Vector2d(std::cos(direction), std::sin(direction));
    return disc;
  });
  EXPECT_EQ(limits.found, kTrials);
  EXPECT_LE(limits.error_px.value(), 0.02);
}

TEST(Limits, CutDiscsAreToldOrRight) {
  for (const double diameter_px : {10.0, 12.0, 16.0, 24.0}) {
    const Limits limits = look(100.0, static_cast<std::uint64_t>(diameter_px), [&](TrialRandom& random) {
      Disc disc = randomDisc(diameter_px, kLeastRatio, random);
      disc.cut = cutOfArea(random.uniform(0.1, 0.4), random.uniform(0.0, 2.0 * std::numbers::pi));
      return disc;
    });
    EXPECT_EQ(limits.silent, 0) << diameter_px;
    EXPECT_LE(limits.found - limits.flagged - limits.good, kTrials / 50) << diameter_px;
  }
}

TEST(Limits, CorrectedCentresAreWithoutBias) {
  const auto rig = fisheyeRig();
  const NoiseTable noise;
  StereoCamera camera(rig, noise);
  StereoVision vision(rig, {}, {});
  RootMeanSquare corrected_px;
  int lost = 0;
  for (std::uint64_t trial = 0; trial < 6; ++trial) {
    TrialRandom random(1, 2, trial);
    const auto discs = randomDiscs(rig, 10, {0.3, 0.6}, 45.0, random);
    const auto frame = camera.shoot(discs, 0.0, random);
    const StereoObservation& seen = vision.observe(frame);
    for (const auto& disc : discs) {
      const StereoPoint* point = pointOf(disc, seen);
      lost += point == nullptr;
      if (point == nullptr) continue;
      corrected_px.addSquare((point->left_px - disc.left_px).squaredNorm(), 2);
      corrected_px.addSquare((point->right_px - disc.right_px).squaredNorm(), 2);
    }
  }
  EXPECT_EQ(lost, 0);
  EXPECT_LE(corrected_px.value(), 0.004);
}

}  // namespace
}  // namespace mirrorarm::vision
