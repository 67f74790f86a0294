#include "core/robot/speed_change.h"

#include <algorithm>
#include <cmath>

namespace mirrorarm::robot {

EndState after(const EndState& from, const JerkPiece& piece) noexcept {
  const double t = piece.duration_s, j = piece.jerk;
  return {from.q + t * (from.v + t * (from.a / 2.0 + t * j / 6.0)), from.v + t * (from.a + t * j / 2.0),
          from.a + t * j};
}

double coastingSpeed(const EndState& from, double jerk) noexcept {
  return from.v + from.a * std::abs(from.a) / (2.0 * jerk);
}

SpeedChange changeSpeed(const EndState& from, double speed, const AxisLimits& limits) noexcept {
  const double j = limits.jerk;
  const double side = speed >= coastingSpeed(from, j) ? 1.0 : -1.0;
  // Seen from `side` the acceleration always rises to a peak >= 0 and falls back to zero.
  const double gain = side * (speed - from.v), a = side * from.a;
  const double wanted = std::sqrt(std::max(0.0, j * gain + 0.5 * a * a));
  const double peak = std::min(wanted, limits.acceleration);
  const double ramp = std::abs(peak - a) / j;
  const double ramp_gain = 0.5 * (peak + a) * ramp + 0.5 * peak * peak / j;
  const double hold = peak < wanted ? std::max(0.0, gain - ramp_gain) / peak : 0.0;
  return {{{ramp, side * std::copysign(j, peak - a)}, {hold, 0.0}, {peak / j, -side * j}}};
}

}  // namespace mirrorarm::robot
