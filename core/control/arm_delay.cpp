#include "core/control/arm_delay.h"

#include <algorithm>

namespace mirrorarm::control {
namespace {

constexpr double kKept = 0.9995;       // of what was known, a cycle
constexpr double kLeastSpeeds = 0.01;  // [rad^2/s^2] summed: below, encoder noise would speak
constexpr double kMost_s = 0.1;

}  // namespace

void ArmDelay::add(const robot::Joints& commanded_rad, const robot::Joints& commanded_rad_s,
                   const robot::Joints& measured_rad) noexcept {
  if (commanded_rad.size() != measured_rad.size() || commanded_rad_s.size() != measured_rad.size()) return;
  const double speed = commanded_rad_s.squaredNorm();
  if (speed == 0.0) return;
  behind_ = kKept * behind_ + commanded_rad_s.dot(commanded_rad - measured_rad);
  speeds_ = kKept * speeds_ + speed;
}

Seconds ArmDelay::value() const noexcept {
  return Seconds(speeds_ < kLeastSpeeds ? 0.0 : std::clamp(behind_ / speeds_, 0.0, kMost_s));
}

}  // namespace mirrorarm::control
