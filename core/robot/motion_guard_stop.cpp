#include "core/robot/motion_guard_stop.h"

namespace mirrorarm::robot {
namespace {

/// After `cycles` more of which each changes the acceleration by `step`.
Moment after(const Moment& from, const Share& step, double cycles, double period_s) {
  const double sum = 0.5 * cycles * (cycles + 1.0), sum_of_sums = sum * (cycles + 2.0) / 3.0;
  Moment moment;
  moment.acceleration = from.acceleration + cycles * step;
  moment.speed = from.speed + period_s * (cycles * from.acceleration + sum * step);
  moment.displacement =
      from.displacement +
      period_s * (cycles * from.speed + period_s * (sum * from.acceleration + sum_of_sums * step));
  return moment;
}

}  // namespace

Stop Stop::afterOneCycle() const {
  Stop left = *this;
  for (int* const part : {&left.release, &left.ramp_in, &left.hold, &left.ramp_out}) {
    if (*part == 0) continue;
    --*part;
    break;
  }
  return left;
}

StopCourse::StopCourse(const Stop& stop, double period_s) : period_s_(period_s) {
  Moment now;
  if (stop.release > 0) now = part(now, -now.acceleration / stop.release, stop.release, 2);
  released_ = now;
  if (stop.ramp_in > 0 || stop.hold > 0) {
    const double ramp_in = stop.ramp_in > 0 ? 0.5 * (stop.ramp_in + 1) : 0.0;
    const double cycles = ramp_in + stop.hold + 0.5 * (stop.ramp_out - 1);
    const double kept = stop.ramp_in > 0 ? 0.5 * (stop.ramp_in - 1) : 0.0;
    const Share plateau = -(now.speed / period_s + kept * now.acceleration) / cycles;
    if (stop.ramp_in > 0) now = part(now, (plateau - now.acceleration) / stop.ramp_in, stop.ramp_in, 3);
    now.acceleration = plateau;
  }
  at_plateau_ = now;
  if (stop.hold > 0) now = part(now, Share(0.0, 0.0), stop.hold, 2);
  at_ramp_out_ = now;
  if (stop.ramp_out > 1) {
    // From the speed rather than the acceleration, so that rounding does not leave any speed.
    now.acceleration = -now.speed / (0.5 * (stop.ramp_out - 1) * period_s);
    now = part(now, -now.acceleration / stop.ramp_out, stop.ramp_out, 1);
  } else if (stop.ramp_out == 1) {
    now.acceleration = -now.speed / period_s;
    now = part(now, Share(0.0, 0.0), 1, 0);
    now.acceleration.setZero();
  }
  at_rest_ = now;
  if (!has_next_) next_ = now;
}

Moment StopCourse::part(Moment from, Share step, int cycles, int samples) {
  if (!has_next_) next_ = after(from, step, 1.0, period_s_);
  has_next_ = true;
  for (int i = 1; i < samples; ++i) {
    const int at = cycles * i / samples;
    if (at > 0) keep(after(from, step, at, period_s_));
  }
  const Moment end = after(from, step, cycles, period_s_);
  if (samples > 0) keep(end);
  return end;
}

}  // namespace mirrorarm::robot
