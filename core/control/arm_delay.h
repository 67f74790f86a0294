#pragma once

#include "core/common/time.h"
#include "core/robot/joints.h"

namespace mirrorarm::control {

/// How long the arm trails its commands, measured while it moves: the time that, times the commanded speeds,
/// explains best how far the measured joints lie behind. Forgets in some seconds of motion. One thread.
class ArmDelay {
 public:
  /// One servo cycle. Joints of different sizes are ignored: the robot was not driven.
  void add(const robot::Joints& commanded_rad, const robot::Joints& commanded_rad_s,
           const robot::Joints& measured_rad) noexcept;

  /// 0 before the arm has moved; never more than 0.1 s.
  [[nodiscard]] Seconds value() const noexcept;

 private:
  double behind_ = 0.0;  ///< sum of speed times distance behind, forgetting
  double speeds_ = 0.0;  ///< sum of squared speeds, forgetting
};

}  // namespace mirrorarm::control
