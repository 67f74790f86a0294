#include "benchmarks/tracking/limb_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mirrorarm::benchmarks::tracking {
namespace {

constexpr double kPath_m = 0.3;

/// `share` 0 to 1 along a path of 300 mm that turns by a radian.
RigidTransform alongPath(double share) {
  const Eigen::Vector3d axis = Eigen::Vector3d(0.3, 0.9, 0.3).normalized();
  return makeTransform(Eigen::Quaterniond(Eigen::AngleAxisd(share, axis)),
                       Eigen::Vector3d(0.26 * share, 0.10 * share, 0.4 + 0.11 * share));
}

LimbMotion swing(double frequency_hz, double amplitude_m, TrialRandom& random) {
  const double phase = random.uniform(0.0, 2.0 * std::numbers::pi);
  return {[=](double t) {
    return alongPath(amplitude_m / kPath_m * std::sin(2.0 * std::numbers::pi * frequency_hz * t + phase));
  }};
}

double minimumJerk(double s) {
  s = std::clamp(s, 0.0, 1.0);
  return s * s * s * (10.0 - 15.0 * s + 6.0 * s * s);
}

LimbMotion reaches(TrialRandom& random) {
  const double begin_s = random.uniform(0.0, 2.4);
  return {[=](double t) {
    const double s = std::fmod(begin_s + t, 2.4);
    return alongPath(s < 1.2 ? minimumJerk(s / 0.8) : 1.0 - minimumJerk((s - 1.2) / 0.8));
  }};
}

/// 0.4 m/s, then none from one instant to the next.
LimbMotion suddenStop(TrialRandom& random) {
  const double stop_s = 0.8 + random.uniform(0.0, 1.0 / 24.0);
  return {[=](double t) { return alongPath(0.4 / kPath_m * (std::min(t, stop_s) - stop_s)); }};
}

/// 0.5 m/s, braked within 0.3 s to rest.
LimbMotion smoothStop(TrialRandom& random) {
  constexpr double kBrake_s = 0.3;
  const double stop_s = 0.8 + random.uniform(0.0, 1.0 / 24.0);
  return {[=](double t) {
    const double s = std::clamp((t - stop_s) / kBrake_s, 0.0, 1.0);
    const double braked = kBrake_s * (s - s * s * s + 0.5 * s * s * s * s);
    return alongPath(0.5 / kPath_m * (std::min(t, stop_s) - stop_s + braked));
  }};
}

LimbMotion rest(TrialRandom& random) {
  const double share = random.uniform(-1.0, 1.0);
  return {[=](double) { return alongPath(share); }};
}

}  // namespace

const std::vector<LimbMotionKind>& limbMotions() {
  static const std::vector<LimbMotionKind> kinds{
      {"swing 0.7 Hz 120 mm", [](TrialRandom& random) { return swing(0.7, 0.12, random); }},
      {"swing 0.55 Hz 120 mm", [](TrialRandom& random) { return swing(0.55, 0.12, random); }},
      {"swing 0.85 Hz 120 mm", [](TrialRandom& random) { return swing(0.85, 0.12, random); }},
      {"swing 1.2 Hz 80 mm", [](TrialRandom& random) { return swing(1.2, 0.08, random); }},
      {"minimum-jerk reaches 300 mm", reaches},
      {"sudden stop from 0.4 m/s", suddenStop, true},
      {"smooth stop from 0.5 m/s", smoothStop, true},
      {"rest", rest},
  };
  return kinds;
}

}  // namespace mirrorarm::benchmarks::tracking
