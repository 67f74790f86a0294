#include <memory>

#include <Eigen/LU>

#include "benchmarks/parallel.h"
#include "benchmarks/statistics.h"
#include "benchmarks/vision/stereo_camera.h"
#include "benchmarks/vision/suite.h"
#include "core/simulation/stereo_renderer.h"
#include "core/vision/stereo_vision.h"

namespace mirrorarm::benchmarks::vision {
namespace {

namespace product = mirrorarm::vision;

constexpr int kDiscsInFrame = 10;
constexpr double kGap_px = 45.0;
constexpr double kSnr = 100.0;

struct PointErrors {
  int discs = 0, points = 0, centres = 0;
  double points_normalised = 0.0;   ///< sum of e' C^-1 e
  double centres_normalised = 0.0;  ///< of the corrected centres in both images
  RootMeanSquare lateral_m, depth_m;

  void add(const StereoDisc& disc, const product::StereoObservation& seen);
  void join(const PointErrors& other);
};

void PointErrors::add(const StereoDisc& disc, const product::StereoObservation& seen) {
  ++discs;
  const auto* point = pointOf(disc, seen);
  if (point == nullptr) return;
  const Eigen::Vector3d off = point->p_C - disc.centre_C;
  ++points;
  points_normalised += off.dot(point->covariance_m2.inverse() * off);
  const Eigen::Vector3d sight = disc.centre_C.normalized();
  depth_m.addSquare(off.dot(sight) * off.dot(sight));
  lateral_m.addSquare((off - off.dot(sight) * sight).squaredNorm(), 2);
  const auto addCentre = [&](const product::DetectedMarker& marker, const Eigen::Vector2d& off_px) {
    ++centres;
    centres_normalised += off_px.dot(marker.covariance_px2.inverse() * off_px);
  };
  addCentre(seen.left.markers[static_cast<std::size_t>(point->left)], point->left_px - disc.left_px);
  addCentre(seen.right.markers[static_cast<std::size_t>(point->right)], point->right_px - disc.right_px);
}

void PointErrors::join(const PointErrors& other) {
  discs += other.discs;
  points += other.points;
  centres += other.centres;
  points_normalised += other.points_normalised;
  centres_normalised += other.centres_normalised;
  lateral_m.join(other.lateral_m);
  depth_m.join(other.depth_m);
}

/// White noise on evenly bright discs, or the simulated sensor with the light of a ring around each lens.
enum class Noise { kWhite, kSensor };

class Shooter {
 public:
  Shooter(const camera::StereoRig& rig, const NoiseTable& table, Noise noise)
      : noise_(noise), white_(rig, table), sensor_(rig, {}, {}) {}

  [[nodiscard]] camera::StereoFrame shoot(const std::vector<StereoDisc>& discs, std::uint64_t seed,
                                          TrialRandom& random) {
    if (noise_ == Noise::kWhite) return white_.shoot(discs, StereoCamera::kContrast / kSnr, random);
    simulation::StereoRenderer::Instant instant;
    for (const StereoDisc& disc : discs) instant.push_back(disc.patch_C());
    camera::StereoFrame frame;
    std::tie(frame.left, frame.right) = sensor_.render({&instant, 1}, seed);
    return frame;
  }

 private:
  Noise noise_;
  StereoCamera white_;
  simulation::StereoRenderer sensor_;
};

PointErrors pointErrors(int frames, Noise noise) {
  const camera::StereoRig rig = fisheyeRig();
  const NoiseTable table;
  const std::uint64_t stream = noise == Noise::kWhite ? 61 : 62;
  std::vector<PointErrors> of_frame(static_cast<std::size_t>(frames));
  forEachTrial(frames, [&] {
    auto vision =
        std::make_unique<product::StereoVision>(rig, product::FinderSettings{}, product::MatcherSettings{});
    return [&, vision = std::move(vision), shooter = Shooter(rig, table, noise)](int index) mutable {
      TrialRandom random(kSeed, stream, static_cast<std::uint64_t>(index));
      const auto discs = randomDiscs(rig, kDiscsInFrame, {}, kGap_px, random);
      const auto frame = shooter.shoot(discs, stream * 1000000 + static_cast<std::uint64_t>(index), random);
      const auto& seen = vision->observe(frame);
      for (const StereoDisc& disc : discs) of_frame[static_cast<std::size_t>(index)].add(disc, seen);
    };
  });
  PointErrors all;
  for (const PointErrors& errors : of_frame) all.join(errors);
  return all;
}

Row honestyRow(const std::string& name, double sum, int freedom, int count) {
  const Interval band = chiSquareMeanBand(freedom, count);
  const double mean = sum / count;
  Row row;
  row.name = name;
  row.goal = "mean of e'C^-1 e from " + shortNumber(band.low) + " to " + shortNumber(band.high);
  row.measured = {{"mean", mean, ""}};
  row.references = {{"trials", 1.0 * count, ""}};
  row.pass = band.holds(mean);
  return row;
}

}  // namespace

void measurePointCovariance(Run& run) {
  for (const Noise noise : {Noise::kWhite, Noise::kSensor}) {
    const PointErrors errors = pointErrors(run.trials(200, 10), noise);
    const std::string with = noise == Noise::kWhite ? ", white noise, SNR 100" : ", simulated sensor";
    Row row = honestyRow("3D points" + with, errors.points_normalised, 3, errors.points);
    row.measured.push_back({"lateral rms per axis", 1e6 * errors.lateral_m.value(), "um"});
    row.measured.push_back({"along the sight", 1e6 * errors.depth_m.value(), "um"});
    row.references.push_back({"not found", 1.0 * (errors.discs - errors.points), ""});
    run.report.rows.push_back(row);
    run.report.rows.push_back(
        honestyRow("corrected centres" + with, errors.centres_normalised, 2, errors.centres));
  }
}

}  // namespace mirrorarm::benchmarks::vision
