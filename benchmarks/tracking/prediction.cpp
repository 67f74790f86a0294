#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/LU>

#include "benchmarks/parallel.h"
#include "benchmarks/statistics.h"
#include "benchmarks/timing.h"
#include "benchmarks/tracking/limb_motion.h"
#include "benchmarks/tracking/pose_error.h"
#include "benchmarks/tracking/suite.h"
#include "core/tracking/motion_predictor.h"

namespace mirrorarm::benchmarks::tracking {
namespace {

using mirrorarm::tracking::MotionPredictor;
using mirrorarm::tracking::UncertainPose;

constexpr std::array<double, 3> kAhead_s{0.02, 0.05, 0.1};
constexpr std::array<const char*, 3> kAhead{"20 ms", "50 ms", "100 ms"};
constexpr double kTurnNoise_rad = 3.2e-4;  // of a pose from ten markers at 400 mm

enum Method : std::size_t { kProduct, kHold, kConstantVelocity, kConstantAcceleration, kMethods };
constexpr std::array<const char*, kMethods> kNames{"", "hold", "constant velocity",
                                                   "3-point constant acceleration"};

/// How poses are measured.
struct Sensing {
  double rate_hz = 24.0;
  Eigen::Vector3d sigma_C = Eigen::Vector3d::Zero();
  std::string name;
};

/// Errors of the place at each time ahead.
struct Outcome {
  std::array<std::array<RootMeanSquare, 3>, kMethods> rms_m;
  std::array<std::array<double, 3>, kMethods> worst_m{};
  std::array<double, 3> nees{};

  void add(Method method, std::size_t k, double error_m) {
    rms_m[method][k].addSquare(error_m * error_m);
    worst_m[method][k] = std::max(worst_m[method][k], error_m);
  }
  void join(const Outcome& other) {
    for (std::size_t k = 0; k < 3; ++k) {
      nees[k] += other.nees[k];
      for (std::size_t m = 0; m < kMethods; ++m) {
        rms_m[m][k].join(other.rms_m[m][k]);
        worst_m[m][k] = std::max(worst_m[m][k], other.worst_m[m][k]);
      }
    }
  }
};

UncertainPose measure(const RigidTransform& X_CT, const Sensing& sensing, TrialRandom& random) {
  const auto normal3 = [&random] {
    return Eigen::Vector3d(random.normal(), random.normal(), random.normal());
  };
  const Eigen::Vector3d turn = kTurnNoise_rad * normal3();
  UncertainPose pose;
  pose.X_CT = X_CT * makeTransform(Eigen::Quaterniond(Eigen::AngleAxisd(turn.norm(), turn.normalized())),
                                   Eigen::Vector3d::Zero());
  pose.X_CT.translation() += sensing.sigma_C.cwiseProduct(normal3());
  const Eigen::Matrix3d variance_C = sensing.sigma_C.cwiseAbs2().asDiagonal();
  const Eigen::Matrix3d R_TC = X_CT.linear().transpose();
  pose.covariance.topLeftCorner<3, 3>() = kTurnNoise_rad * kTurnNoise_rad * Eigen::Matrix3d::Identity();
  pose.covariance.bottomRightCorner<3, 3>() = R_TC * variance_C * R_TC.transpose();
  return pose;
}

/// The last three measured places, the newest first, carried on by polynomials.
std::array<Eigen::Vector3d, kMethods> extrapolated(const std::array<Eigen::Vector3d, 3>& last_C,
                                                   double step_s, double ahead_s) {
  const Eigen::Vector3d velocity = (last_C[0] - last_C[1]) / step_s;
  const Eigen::Vector3d acceleration = (last_C[0] - 2.0 * last_C[1] + last_C[2]) / (step_s * step_s);
  std::array<Eigen::Vector3d, kMethods> places;
  places[kHold] = last_C[0];
  places[kConstantVelocity] = last_C[0] + velocity * ahead_s;
  places[kConstantAcceleration] =
      places[kConstantVelocity] + 0.5 * acceleration * ahead_s * (ahead_s + step_s);
  return places;
}

void judge(const MotionPredictor& predictor, const std::array<Eigen::Vector3d, 3>& last_C,
           const LimbMotion& motion, double time_s, const Sensing& sensing, Outcome& outcome) {
  for (std::size_t k = 0; k < 3; ++k) {
    const RigidTransform X_CT_true = motion.at(time_s + kAhead_s[k]);
    const UncertainPose foretold = predictor.at(TimePoint(toClock(Seconds(time_s + kAhead_s[k]))));
    auto places = extrapolated(last_C, 1.0 / sensing.rate_hz, kAhead_s[k]);
    places[kProduct] = foretold.X_CT.translation();
    for (std::size_t m = 0; m < kMethods; ++m)
      outcome.add(static_cast<Method>(m), k, (places[m] - X_CT_true.translation()).norm());
    outcome.nees[k] += squaredSigmas(foretold, X_CT_true);
  }
}

Outcome trial(const LimbMotion& motion, const Sensing& sensing, TrialRandom& random) {
  MotionPredictor predictor;
  std::array<Eigen::Vector3d, 3> last_C;
  last_C.fill(Eigen::Vector3d::Zero());
  Outcome outcome;
  for (int i = 0; i / sensing.rate_hz < motion.judged_to_s; ++i) {
    const double time_s = i / sensing.rate_hz;
    const UncertainPose seen = measure(motion.at(time_s), sensing, random);
    predictor.add(TimePoint(toClock(Seconds(time_s))), seen);
    last_C = {seen.X_CT.translation(), last_C[0], last_C[1]};
    if (time_s >= motion.judged_from_s) judge(predictor, last_C, motion, time_s, sensing, outcome);
  }
  return outcome;
}

Outcome trials(int count, const LimbMotionKind& kind, const Sensing& sensing) {
  std::vector<Outcome> outcomes(static_cast<std::size_t>(count));
  forEachTrial(count, [&] {
    return [&](int index) {
      TrialRandom random(kSeed, 81, static_cast<std::uint64_t>(index));
      const LimbMotion motion = kind.make(random);
      outcomes[static_cast<std::size_t>(index)] = trial(motion, sensing, random);
    };
  });
  Outcome all;
  for (const Outcome& outcome : outcomes) all.join(outcome);
  return all;
}

std::string listed(const std::array<double, 3>& numbers) {
  return shortNumber(numbers[0]) + ", " + shortNumber(numbers[1]) + ", " + shortNumber(numbers[2]);
}

Row rmsRow(const LimbMotionKind& kind, const Sensing& sensing, const Outcome& outcome,
           const std::optional<std::array<double, 3>>& goal_mm) {
  Row row;
  row.name = "rms, " + kind.name + sensing.name;
  for (std::size_t k = 0; k < 3; ++k)
    row.measured.push_back({kAhead[k], 1e3 * outcome.rms_m[kProduct][k].value(), "mm"});
  for (std::size_t m = kHold; m < kMethods; ++m)
    for (std::size_t k = 0; k < 3; ++k)
      row.references.push_back(
          {std::string(kNames[m]) + " " + kAhead[k], 1e3 * outcome.rms_m[m][k].value(), "mm"});
  if (!goal_mm) return row;
  row.goal = "<= " + listed(*goal_mm) + " mm at 20, 50, 100 ms";
  row.pass = true;
  for (std::size_t k = 0; k < 3; ++k) row.pass = *row.pass && row.measured[k].value <= (*goal_mm)[k];
  return row;
}

Row worstRow(const LimbMotionKind& kind, const Sensing& sensing, const Outcome& outcome) {
  Row row;
  row.name = "largest error, " + kind.name + sensing.name;
  row.goal = "no more than 5 % larger than by holding the last pose";
  row.pass = true;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& worst_m = outcome.worst_m;
    row.measured.push_back({kAhead[k], 1e3 * worst_m[kProduct][k], "mm"});
    row.pass = *row.pass && worst_m[kProduct][k] <= 1.05 * worst_m[kHold][k];
    for (std::size_t m = kHold; m < kMethods; ++m)
      row.references.push_back({std::string(kNames[m]) + " " + kAhead[k], 1e3 * worst_m[m][k], "mm"});
  }
  return row;
}

Row honestyRow(const LimbMotionKind& kind, const Sensing& sensing, const Outcome& outcome) {
  Row row;
  row.name = "covariance, " + kind.name + sensing.name;
  row.goal = "mean of e'C^-1 e <= 7.2: never optimistic by more than 20 %";
  row.pass = true;
  for (std::size_t k = 0; k < 3; ++k) {
    const double mean = outcome.nees[k] / outcome.rms_m[kProduct][k].count();
    row.measured.push_back({kAhead[k], mean, ""});
    row.pass = *row.pass && mean <= 7.2;
  }
  return row;
}

std::vector<Sensing> sensings() {
  const Eigen::Vector3d fine(4e-6, 4e-6, 17e-6), coarse = Eigen::Vector3d::Constant(1e-4);
  return {{24.0, fine, ", 24 Hz"},
          {120.0, fine, ", 120 Hz"},
          {24.0, coarse, ", 24 Hz, noise 0.1 mm"},
          {120.0, coarse, ", 120 Hz, noise 0.1 mm"}};
}

std::optional<std::array<double, 3>> goalOf(const LimbMotionKind& kind, const Sensing& sensing) {
  if (&kind != &limbMotions().front() || sensing.sigma_C.x() > 1e-5) return std::nullopt;
  if (sensing.rate_hz < 100.0) return std::array{0.16, 0.75, 3.1};
  return std::array{0.03, 0.24, 1.6};
}

Row timeRow() {
  TrialRandom random(kSeed, 82, 0);
  const LimbMotion motion = limbMotions().front().make(random);
  std::vector<UncertainPose> poses;
  const Sensing sensing = sensings().front();
  for (int i = 0; i < 2000; ++i) poses.push_back(measure(motion.at(i / sensing.rate_hz), sensing, random));
  MotionPredictor predictor;
  const Timing timing = timed(2000, [&](int i) {
    predictor.add(TimePoint(toClock(Seconds(i / sensing.rate_hz))), poses[static_cast<std::size_t>(i)]);
  });
  Row row;
  row.name = "time to take a pose in";
  row.measured = {{"median", 1e3 * timing.median_ms, "us"}, {"p99", 1e3 * timing.p99_ms, "us"}};
  return row;
}

}  // namespace

void measurePrediction(Run& run) {
  for (const Sensing& sensing : sensings())
    for (const LimbMotionKind& kind : limbMotions()) {
      const Outcome outcome = trials(run.trials(1000, 20), kind, sensing);
      run.report.rows.push_back(rmsRow(kind, sensing, outcome, goalOf(kind, sensing)));
      run.report.rows.push_back(kind.stops ? worstRow(kind, sensing, outcome)
                                           : honestyRow(kind, sensing, outcome));
    }
  run.report.rows.push_back(timeRow());
}

}  // namespace mirrorarm::benchmarks::tracking
