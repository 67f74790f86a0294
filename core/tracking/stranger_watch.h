#pragma once

#include <array>
#include <span>

#include <Eigen/Core>

#include "core/common/time.h"

namespace mirrorarm::tracking {

/// A point that is no marker of the target, followed in the frame T of a body.
struct Stranger {
  bool alive = false;
  TimePoint first_seen{}, last_seen{};
  int frames = 0;  ///< in which it was seen
  int frames_missed = 0;
  Eigen::Vector3d last_T = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Vector3d mean_T = Eigen::Vector3d::Zero();
  Eigen::Vector3d mean_C = Eigen::Vector3d::Zero();
  double scatter_T_m2 = 0.0;  ///< sum of squared distances from the mean
  double scatter_C_m2 = 0.0;
};

/// Follows strangers from frame to frame in the frame of a body. One that moves with the body scatters little
/// there and widely before the camera; one that stands still beside a still arm does neither, and proves
/// nothing. At most kMostStrangers are followed.
class StrangerWatch {
 public:
  static constexpr std::size_t kMostStrangers = 32;

  /// Before the strangers of a frame; then seen() for each, then end().
  void begin(TimePoint time, double gate_m);
  void seen(const Eigen::Vector3d& p_T, const Eigen::Vector3d& p_C);
  void end();
  void forget(std::size_t stranger) { strangers_[stranger] = {}; }

  [[nodiscard]] std::span<const Stranger> strangers() const { return strangers_; }
  /// True when it has moved with the body for `time` while the body moved.
  [[nodiscard]] static bool movesWithBody(const Stranger& stranger, Seconds time, double skin_variance_m2);

 private:
  std::array<Stranger, kMostStrangers> strangers_{};
  TimePoint time_{};
  double gate_m_ = 0.0;
};

}  // namespace mirrorarm::tracking
