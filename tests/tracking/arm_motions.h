#pragma once

#include <array>
#include <functional>

#include "core/tracking/motion_predictor.h"
#include "tests/tracking/stereo_sight.h"

namespace mirrorarm::tracking::test {

/// Where a forearm is at a time [s].
using Motion = std::function<RigidTransform(double)>;

/// `share` 0 to 1 along a path that shifts by 300 mm and turns by a radian.
inline RigidTransform alongPath(double share) {
  const Vector3d axis = Vector3d(0.3, 0.9, 0.3).normalized();
  return makeTransform(Eigen::Quaterniond(Eigen::AngleAxisd(share, axis)),
                       Vector3d(0.26 * share, 0.10 * share, 0.4 + 0.11 * share));
}

/// Swings of `amplitude_m` to either side, turning with it.
inline Motion swing(double frequency_hz, double amplitude_m) {
  return [=](double t) {
    return alongPath(amplitude_m / 0.3 * std::sin(2.0 * std::numbers::pi * frequency_hz * t));
  };
}

/// Minimum jerk from 0 to 1 in unit time. Source: Flash and Hogan, J. Neuroscience 5(7), 1985.
inline double minimumJerk(double s) {
  s = std::clamp(s, 0.0, 1.0);
  return s * s * s * (10.0 - 15.0 * s + 6.0 * s * s);
}

/// Reaches of 300 mm in 0.8 s there and back, with rests of 0.4 s.
inline RigidTransform reaches(double t) {
  const double s = std::fmod(t, 2.4);
  return alongPath(s < 1.2 ? minimumJerk(s / 0.8) : 1.0 - minimumJerk((s - 1.2) / 0.8));
}

/// Even motion at 0.4 m/s that stops dead at `stop_s`, as when the hand meets a table.
inline Motion suddenStop(double stop_s) {
  return [=](double t) { return alongPath(0.4 / 0.3 * (std::min(t, stop_s) - stop_s)); };
}

/// A swing of 0.7 Hz, 120 mm that comes to rest within `brake_s` after `stop_s`, never turning back.
inline Motion smoothStop(double stop_s, double brake_s) {
  return [=](double t) {
    const double speed = 0.5 / 0.3;
    const double s = std::clamp((t - stop_s) / brake_s, 0.0, 1.0);
    const double braked = brake_s * (s - s * s * s + 0.5 * s * s * s * s);  // its speed falls as 1-3s^2+2s^3
    return alongPath(speed * (std::min(t, stop_s) - stop_s + braked));
  };
}

/// Errors at 20, 50 and 100 ms ahead of each measured pose.
struct Foretold {
  static constexpr std::array<double, 3> kAhead_s{0.02, 0.05, 0.1};
  std::array<double, 3> squares{}, held_squares{};  ///< of shift [m^2], sums
  std::array<double, 3> nees{};                     ///< sums
  int count = 0;

  [[nodiscard]] double rms_mm(std::size_t k) const { return 1e3 * std::sqrt(squares[k] / count); }
  [[nodiscard]] double heldRms_mm(std::size_t k) const { return 1e3 * std::sqrt(held_squares[k] / count); }
  [[nodiscard]] double meanNees(std::size_t k) const { return nees[k] / count; }
};

/// What a tracked pose is like: 0.004, 0.004, 0.017 mm along the camera's axes and 0.02 degrees, times
/// `scale`.
struct PoseNoise {
  PoseNoise(unsigned seed, double noise_scale) : noise(seed), scale(noise_scale) {}

  UncertainPose measure(const RigidTransform& X_CT) {
    const Vector3d sigma_C = scale * Vector3d(4e-6, 4e-6, 17e-6);
    const double turn_sigma = scale * 3.5e-4;
    const Vector3d turn = noise.gaussian(turn_sigma);
    const RigidTransform nudge = makeTransform(
        Eigen::Quaterniond(Eigen::AngleAxisd(turn.norm(), turn.normalized())), Vector3d::Zero());
    UncertainPose pose;
    pose.X_CT = X_CT * nudge;
    pose.X_CT.translation() += sigma_C.cwiseProduct(noise.gaussian(1.0));
    const Eigen::Matrix3d R_TC = X_CT.linear().transpose();
    const Eigen::Matrix3d variance_C = sigma_C.cwiseAbs2().asDiagonal();
    pose.covariance.topLeftCorner<3, 3>() = turn_sigma * turn_sigma * Eigen::Matrix3d::Identity();
    pose.covariance.bottomRightCorner<3, 3>() = R_TC * variance_C * R_TC.transpose();
    return pose;
  }

  Noise noise;
  double scale;
};

inline TimePoint atSecond(double t) { return TimePoint(toClock(Seconds(100.0 + t))); }

inline double shiftError(const RigidTransform& X, const RigidTransform& X_true) {
  return (X.translation() - X_true.translation()).norm();
}

/// Runs a predictor over `duration_s` of frames; the first 0.4 s are not judged.
inline Foretold foretell(const Motion& motion, double rate_hz, double noise_scale, double duration_s = 20.0) {
  PoseNoise sensor(7, noise_scale);
  MotionPredictor predictor;
  Foretold result;
  for (double t = 0.0; t < duration_s; t += 1.0 / rate_hz) {
    const UncertainPose seen = sensor.measure(motion(t));
    predictor.add(atSecond(t), seen);
    if (t < 0.4) continue;
    ++result.count;
    for (std::size_t k = 0; k < 3; ++k) {
      const RigidTransform X_true = motion(t + Foretold::kAhead_s[k]);
      const UncertainPose foretold = predictor.at(atSecond(t + Foretold::kAhead_s[k]));
      const double error = shiftError(foretold.X_CT, X_true), held = shiftError(seen.X_CT, X_true);
      result.squares[k] += error * error;
      result.held_squares[k] += held * held;
      result.nees[k] += squaredSigmas(foretold.X_CT, foretold.covariance, X_true);
    }
  }
  return result;
}

}  // namespace mirrorarm::tracking::test
