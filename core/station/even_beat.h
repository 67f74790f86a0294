#pragma once

#include <algorithm>
#include <stop_token>
#include <thread>

#include "core/common/time.h"

namespace mirrorarm::station {

/// Calls `step` at an even beat until asked to stop; a beat that was missed is skipped, not made up for.
template <class Step>
void atEvenBeat(const std::stop_token& stop, Seconds period, Step step) {
  auto due = Clock::now();
  while (!stop.stop_requested()) {
    step(Clock::now());
    due = std::max(due + toClock(period), Clock::now());
    std::this_thread::sleep_until(due);
  }
}

/// The same on a clock that somebody sets: true once a period.
class DueBeat {
 public:
  explicit DueBeat(Seconds period) : period_(period) {}
  [[nodiscard]] bool isDue(TimePoint now) {
    if (now < next_) return false;
    next_ = now + toClock(period_);
    return true;
  }

 private:
  Seconds period_;
  TimePoint next_{};
};

}  // namespace mirrorarm::station
