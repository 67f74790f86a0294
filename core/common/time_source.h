#pragma once

#include <atomic>

#include "core/common/time.h"

namespace mirrorarm {

/// Where the stages read the time, so that a whole session can also run faster than the wall clock.
class TimeSource {
 public:
  virtual ~TimeSource() = default;
  /// Any thread.
  [[nodiscard]] virtual TimePoint now() const noexcept = 0;
};

/// The machine's own clock.
class SteadyTime final : public TimeSource {
 public:
  [[nodiscard]] TimePoint now() const noexcept override { return Clock::now(); }
};

/// A clock that stands still until it is set. One thread sets it, any thread reads it.
class ManualTime final : public TimeSource {
 public:
  [[nodiscard]] TimePoint now() const noexcept override {
    return TimePoint(Clock::duration(ticks_.load(std::memory_order_acquire)));
  }
  void set(TimePoint time) noexcept {
    ticks_.store(time.time_since_epoch().count(), std::memory_order_release);
  }

 private:
  std::atomic<Clock::duration::rep> ticks_{0};
};

}  // namespace mirrorarm
