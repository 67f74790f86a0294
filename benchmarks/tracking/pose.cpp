#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include <Eigen/LU>

#include "benchmarks/parallel.h"
#include "benchmarks/statistics.h"
#include "benchmarks/timing.h"
#include "benchmarks/tracking/pose_error.h"
#include "benchmarks/tracking/suite.h"
#include "benchmarks/tracking/target_view.h"
#include "core/geometry/rigid_fit.h"
#include "core/simulation/stereo_renderer.h"
#include "core/vision/stereo_vision.h"

namespace mirrorarm::benchmarks::tracking {
namespace {

using mirrorarm::tracking::MarkerMatch;
using mirrorarm::tracking::PoseEstimate;
using mirrorarm::tracking::PoseEstimator;
using Matches = std::vector<MarkerMatch>;

constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr double kCentreNoise_px = 0.02;
constexpr std::size_t kCovered = 5;  // of ten markers

/// Errors of one method, along the camera's axes.
struct Errors {
  std::array<RootMeanSquare, 3> shift_m;
  RootMeanSquare turn_rad, fit_m;

  void add(const RigidTransform& X_CT, const RigidTransform& X_CT_true, double fit_rms_m) {
    const Eigen::Vector3d off = X_CT.translation() - X_CT_true.translation();
    for (std::size_t k = 0; k < 3; ++k) {
      const double along = off[static_cast<Eigen::Index>(k)];
      shift_m[k].addSquare(along * along);
    }
    const double turn = angleBetween(X_CT, X_CT_true);
    turn_rad.addSquare(turn * turn);
    fit_m.addSquare(fit_rms_m * fit_rms_m);
  }
  [[nodiscard]] std::vector<Figure> figures(const std::string& name) const {
    const std::string prefix = name.empty() ? "" : name + " ";
    return {{prefix + "x", 1e3 * shift_m[0].value(), "mm"},
            {prefix + "y", 1e3 * shift_m[1].value(), "mm"},
            {prefix + "z", 1e3 * shift_m[2].value(), "mm"},
            {prefix + "turn", kDegrees * turn_rad.value(), "deg"}};
  }
};

/// One trial: what was matched, and the truth; no matches where too few discs were seen.
struct Sight {
  Matches matches;
  RigidTransform X_CT_true = RigidTransform::Identity();
};

RigidTransform kabschOf(const Matches& matches) {
  std::vector<Eigen::Vector3d> markers_T, points_C;
  for (const MarkerMatch& match : matches) {
    markers_T.push_back(match.marker_T);
    points_C.push_back(match.point_C);
  }
  return fitByKabsch(markers_T, points_C);
}

/// What a method with covariances and one without make of the same sights.
struct Comparison {
  Errors estimator, kabsch;
  double nees = 0.0;
  int trials = 0;

  explicit Comparison(const std::vector<Sight>& sights) {
    PoseEstimator likelihood;
    for (const Sight& sight : sights) {
      if (sight.matches.size() < 3) continue;
      const RigidTransform start = kabschOf(sight.matches);
      kabsch.add(start, sight.X_CT_true, 0.0);
      const auto& estimate = likelihood.estimate(sight.matches, start);
      estimator.add(estimate.X_CT, sight.X_CT_true, estimate.rms_m);
      nees += squaredSigmas(estimate, sight.X_CT_true);
      ++trials;
    }
  }
};

Row accuracyRow(const std::string& name, const Comparison& found, bool judged) {
  Row row;
  row.name = "error, " + name;
  row.measured = found.estimator.figures("");
  row.references = found.kabsch.figures("Kabsch");
  row.references.push_back({"trials", 1.0 * found.trials, ""});
  if (!judged) return row;
  row.goal = "x, y, z <= 0.004, 0.004, 0.017 mm, turn <= 0.03 deg";
  const double limits[] = {0.004, 0.004, 0.017, 0.03};
  row.pass = true;
  for (std::size_t k = 0; k < 4; ++k) row.pass = *row.pass && row.measured[k].value <= limits[k];
  return row;
}

Row fitRow(const std::string& name, const Comparison& found, std::optional<double> limit_mm) {
  Row row;
  row.name = "fit rms, " + name;
  row.measured = {{"rms", 1e3 * found.estimator.fit_m.value(), "mm"}};
  if (!limit_mm) return row;
  row.goal = "<= " + shortNumber(*limit_mm) + " mm";
  row.pass = row.measured[0].value <= *limit_mm;
  return row;
}

Row honestyRow(const std::string& name, const Comparison& found) {
  const Interval band = chiSquareMeanBand(6, found.trials);
  Row row;
  row.name = "covariance, " + name;
  row.goal = "mean of e'C^-1 e from " + shortNumber(band.low) + " to " + shortNumber(band.high);
  row.measured = {{"mean", found.nees / found.trials, ""}};
  row.references = {{"trials", 1.0 * found.trials, ""}};
  row.pass = band.holds(row.measured[0].value);
  return row;
}

void coverSome(Sight& sight, TrialRandom& random) {
  while (sight.matches.size() > kCovered)
    sight.matches.erase(sight.matches.begin() + random.index(static_cast<int>(sight.matches.size())));
}

std::vector<Sight> sightsOfNoise(int trials, bool covered) {
  const camera::StereoRig rig = vision::fisheyeRig();
  const auto discs_T = forearmDiscs_T();
  std::vector<Sight> sights(static_cast<std::size_t>(trials));
  forEachTrial(trials, [&] {
    return [&](int trial) {
      TrialRandom random(kSeed, covered ? 72 : 71, static_cast<std::uint64_t>(trial));
      Sight& sight = sights[static_cast<std::size_t>(trial)];
      sight.X_CT_true = forearmPose(random);
      const auto discs_C = discsAt(rig, discs_T, sight.X_CT_true);
      sight.matches = measuredMatches(rig, discs_T, discs_C, kCentreNoise_px, random);
      if (covered) coverSome(sight, random);
    };
  });
  return sights;
}

Matches matchesOf(const std::vector<vision::StereoDisc>& discs_T,
                  const std::vector<vision::StereoDisc>& discs_C,
                  const mirrorarm::vision::StereoObservation& seen) {
  Matches matches;
  for (std::size_t i = 0; i < discs_T.size(); ++i)
    if (const auto* point = vision::pointOf(discs_C[i], seen))
      matches.push_back({discs_T[i].centre_C, Eigen::Matrix3d::Zero(), point->p_C, point->covariance_m2});
  return matches;
}

/// Through whole images: the simulated sensor, its light and noise, detection, matching, triangulation.
std::vector<Sight> sightsOfImages(int trials, bool covered) {
  const camera::StereoRig rig = vision::fisheyeRig();
  const auto discs_T = forearmDiscs_T();
  const std::uint64_t stream = covered ? 74 : 73;
  std::vector<Sight> sights(static_cast<std::size_t>(trials));
  forEachTrial(trials, [&] {
    auto eyes = std::make_unique<mirrorarm::vision::StereoVision>(rig, mirrorarm::vision::FinderSettings{},
                                                                  mirrorarm::vision::MatcherSettings{});
    return [&, eyes = std::move(eyes), sensor = simulation::StereoRenderer(rig, {}, {})](int trial) mutable {
      TrialRandom random(kSeed, stream, static_cast<std::uint64_t>(trial));
      Sight& sight = sights[static_cast<std::size_t>(trial)];
      sight.X_CT_true = forearmPose(random);
      const auto discs_C = discsAt(rig, discs_T, sight.X_CT_true);
      simulation::StereoRenderer::Instant instant;
      for (const auto& disc : discs_C) instant.push_back(disc.patch_C());
      camera::StereoFrame frame;
      std::tie(frame.left, frame.right) =
          sensor.render({&instant, 1}, stream * 1000000 + static_cast<std::uint64_t>(trial));
      sight.matches = matchesOf(discs_T, discs_C, eyes->observe(frame));
      if (covered) coverSome(sight, random);
    };
  });
  return sights;
}

Row timeRow(const std::vector<Sight>& sights) {
  PoseEstimator estimator;
  RigidTransform start = RigidTransform::Identity();
  const Timing timing = timed(static_cast<int>(sights.size()), [&](int i) {
    const Sight& sight = sights[static_cast<std::size_t>(i)];
    start = sight.X_CT_true;
    start.translation().x() += 0.002;  // a warm start is off by so much
    (void)estimator.estimate(sight.matches, start);
  });
  Row row;
  row.name = "time of the estimate, ten markers";
  row.measured = {{"median", 1e3 * timing.median_ms, "us"}, {"p99", 1e3 * timing.p99_ms, "us"}};
  return row;
}

}  // namespace

void measurePose(Run& run) {
  auto& rows = run.report.rows;
  const auto add = [&](const std::string& name, const std::vector<Sight>& sights, bool judged,
                       std::optional<double> fit_limit_mm) {
    const Comparison found(sights);
    rows.push_back(accuracyRow(name, found, judged));
    rows.push_back(fitRow(name, found, fit_limit_mm));
    rows.push_back(honestyRow(name, found));
  };
  const auto sights = sightsOfNoise(run.trials(4000, 50), false);
  add("centres with 0.02 px of noise", sights, true, std::nullopt);
  add("the same, half the markers covered", sightsOfNoise(run.trials(4000, 50), true), false, std::nullopt);
  add("whole images", sightsOfImages(run.trials(3000, 10), false), true, 0.05);
  add("whole images, half the markers covered", sightsOfImages(run.trials(1000, 10), true), false, 0.08);
  rows.push_back(timeRow(sights));
}

}  // namespace mirrorarm::benchmarks::tracking
