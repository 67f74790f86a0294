#pragma once

#include <atomic>
#include <cstdint>

#include "core/control/stop_reason.h"

namespace mirrorarm::control {

/// Whether the robot is stopped, and why. Any thread stops at any time; nothing waits.
class StopLatch {
 public:
  /// The latch at one moment. Two that are equal had no stop and no reset in between.
  struct Value {
    StopReason reason = StopReason::kNone;
    std::uint64_t changes = 0;
    bool operator==(const Value&) const = default;
  };

  /// The first reason stays until the reset; every further stop still counts as a change.
  void stop(StopReason reason) noexcept {
    std::uint64_t word = word_.load(std::memory_order_acquire);
    for (;;) {
      const Value now = unpack(word);
      const std::uint64_t next = pack(now.reason == StopReason::kNone ? reason : now.reason, now.changes + 1);
      if (word_.compare_exchange_weak(word, next, std::memory_order_acq_rel)) return;
    }
  }

  /// Frees the latch if nobody stopped again since it was `seen`: no press of STOP is lost to a reset that
  /// was on its way.
  bool reset(Value seen) noexcept {
    std::uint64_t word = pack(seen.reason, seen.changes);
    return word_.compare_exchange_strong(word, pack(StopReason::kNone, seen.changes + 1),
                                         std::memory_order_acq_rel);
  }

  [[nodiscard]] Value value() const noexcept { return unpack(word_.load(std::memory_order_acquire)); }

 private:
  static constexpr unsigned kReasonBits = 8;
  static Value unpack(std::uint64_t word) noexcept {
    return {static_cast<StopReason>(word & ((1U << kReasonBits) - 1U)), word >> kReasonBits};
  }
  static std::uint64_t pack(StopReason reason, std::uint64_t changes) noexcept {
    return (changes << kReasonBits) | static_cast<std::uint64_t>(reason);
  }

  std::atomic<std::uint64_t> word_{0};  // the reason in the low bits, the number of changes above
};

}  // namespace mirrorarm::control
