#pragma once

#include <atomic>
#include <cstdint>

#include "core/control/stop_reason.h"

namespace mirrorarm::control {

/// Whether the robot is stopped, and why. Any thread sets and resets it at any time; nothing waits.
class StopLatch {
 public:
  /// The latch at one moment. Two that are equal had no stop and no reset in between.
  struct Value {
    StopReason reason = StopReason::kNone;
    std::uint64_t changes = 0;
    bool operator==(const Value&) const = default;
  };

  /// The first reason stays until the reset.
  void stop(StopReason reason) noexcept {
    change([reason](StopReason now) { return now == StopReason::kNone ? reason : now; });
  }
  void reset() noexcept {
    change([](StopReason) { return StopReason::kNone; });
  }
  [[nodiscard]] Value value() const noexcept { return unpack(word_.load(std::memory_order_acquire)); }

 private:
  static constexpr unsigned kReasonBits = 8;
  static Value unpack(std::uint64_t word) noexcept {
    return {static_cast<StopReason>(word & ((1U << kReasonBits) - 1U)), word >> kReasonBits};
  }

  template <class Next>
  void change(Next next) noexcept {
    std::uint64_t word = word_.load(std::memory_order_acquire);
    for (;;) {
      const Value now = unpack(word);
      const StopReason then = next(now.reason);
      if (then == now.reason) return;
      const auto changed = ((now.changes + 1U) << kReasonBits) | static_cast<std::uint64_t>(then);
      if (word_.compare_exchange_weak(word, changed, std::memory_order_acq_rel)) return;
    }
  }

  std::atomic<std::uint64_t> word_{0};  // the reason in the low bits, the number of changes above
};

}  // namespace mirrorarm::control
