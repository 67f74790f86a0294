#pragma once

#include <array>
#include <cstddef>

#include "core/robot/joints.h"

namespace mirrorarm::devices {

/// Speed of joints of which only angles are measured: the slope of the line of least squares through the last
/// 16. Encoder noise of 1e-5 rad at 1 ms becomes 5e-4 rad/s; what is told is 8 cycles old. Does not allocate.
class JointSpeed {
 public:
  /// Begins anew.
  void reset() noexcept { count_ = 0; }

  /// The next angles, `elapsed_s` after those before.
  void add(const robot::Joints& q_rad, double elapsed_s) noexcept {
    time_s_ = count_ == 0 ? 0.0 : time_s_ + elapsed_s;
    samples_[count_++ % kSamples] = {time_s_, q_rad};
  }

  /// Zero after a single sample. At least one was added.
  [[nodiscard]] robot::Joints value() const noexcept {
    const std::size_t known = count_ < kSamples ? count_ : kSamples;
    double mean_s = 0.0;
    for (std::size_t i = 0; i < known; ++i) mean_s += samples_[i].time_s / static_cast<double>(known);
    robot::Joints moment = robot::Joints::Zero(samples_[0].q_rad.size());
    double spread_s2 = 0.0;
    for (std::size_t i = 0; i < known; ++i) {
      const double s = samples_[i].time_s - mean_s;
      moment += s * (samples_[i].q_rad - samples_[0].q_rad);
      spread_s2 += s * s;
    }
    if (spread_s2 > 0.0) moment /= spread_s2;
    return moment;
  }

 private:
  static constexpr std::size_t kSamples = 16;
  struct Sample {
    double time_s = 0.0;
    robot::Joints q_rad;
  };
  std::array<Sample, kSamples> samples_;
  std::size_t count_ = 0;
  double time_s_ = 0.0;
};

}  // namespace mirrorarm::devices
