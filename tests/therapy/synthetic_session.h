#pragma once

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "core/therapy/session_measures.h"

namespace mirrorarm::therapy {

/// A healthy arm that swings 100 mm out and back every 4 s, and an end effector that does the same `lag_s`
/// later and `gain` times as far, seen at 24 Hz with white noise.
struct SyntheticSession {
  double seconds = 40.0, rate_hz = 24.0, lag_s = 0.137, gain = 1.0, noise_m = 0.0003;
  double shift_m = 0.1, turn_rad = 0.0, period_s = 4.0;

  [[nodiscard]] double swing(double time_s) const {
    return 0.5 * (1.0 - std::cos(2.0 * std::numbers::pi * time_s / period_s));
  }
  [[nodiscard]] std::vector<Sample> samples() const {
    std::mt19937 random(11);
    std::normal_distribution<double> noise(0.0, noise_m);
    const auto noisy = [&](const Eigen::Vector3d& p) -> Eigen::Vector3d {
      return p + Eigen::Vector3d(noise(random), noise(random), noise(random));
    };
    const Eigen::Vector3d direction = Eigen::Vector3d(1.0, -0.5, 2.0).normalized();
    std::vector<Sample> samples;
    for (int i = 0; i < static_cast<int>(seconds * rate_hz); ++i) {
      Sample sample;
      sample.time_s = i / rate_hz;
      sample.training = true;
      sample.status = tracking::TrackStatus::kTracked;
      sample.matched = 10;
      sample.rms_m = 0.0002;
      const double now = swing(sample.time_s), earlier = swing(sample.time_s - lag_s);
      sample.X_BT =
          makeTransform(Eigen::AngleAxisd(turn_rad * now, Eigen::Vector3d::UnitX()).toRotationMatrix(),
                        noisy(Eigen::Vector3d(0.6, 0.2, 0.3) + shift_m * now * direction));
      sample.X_BE_goal.translation() = sample.X_BT.translation() - Eigen::Vector3d(0.0, 0.4, 0.0);
      sample.X_BE.translation() =
          noisy(Eigen::Vector3d(0.6, -0.2, 0.3) + gain * shift_m * earlier * direction);
      sample.q_rad = robot::Joints::Constant(7, 0.1);
      sample.v_rad_s = robot::Joints::Constant(7, 0.12 * std::sin(sample.time_s));
      sample.a_rad_s2 = robot::Joints::Constant(7, 0.4 * std::cos(sample.time_s));
      samples.push_back(sample);
    }
    return samples;
  }
  [[nodiscard]] SessionMeasures measures() const { return measured(samples()); }
  [[nodiscard]] static SessionMeasures measured(const std::vector<Sample>& samples) {
    return measure(samples, robot::Joints::Constant(7, 0.24), robot::Joints::Constant(7, 0.8));
  }
};

}  // namespace mirrorarm::therapy
