#pragma once

#include "core/common/time.h"

namespace mirrorarm::control {

/// Turns the times at which a thread really woke into an even beat. A robot executes one command a period,
/// however late the thread was within it: a motion sampled at the wake-up times would arrive with jumps in
/// its speed. The beat follows the clock gently, and jumps to it only when it is far off. One thread.
class Beat {
 public:
  explicit Beat(Seconds period) : period_(period) {}

  /// The next beat, for a cycle that runs at `now`.
  TimePoint next(TimePoint now) noexcept;

 private:
  Seconds period_;
  TimePoint last_{};
  double hurry_ = 0.0;  // share of the period by which the beat runs faster
  bool running_ = false;
};

}  // namespace mirrorarm::control
