#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <optional>

namespace mirrorarm {

/// Bounded first-in first-out queue from ANY number of writer threads to ONE reader thread.
///
/// Neither side waits, locks or allocates. A full queue refuses: the writer must say so aloud.
/// Needs T default constructible and movable without throwing. Source: D. Vyukov's bounded queue with a
/// sequence number a cell. `Capacity` is a power of two.
template <class T, std::size_t Capacity>
class BoundedQueue {
  static_assert(Capacity >= 2 && (Capacity & (Capacity - 1)) == 0, "a power of two");

 public:
  BoundedQueue() {
    for (std::size_t i = 0; i < Capacity; ++i) cells_[i].sequence.store(i, std::memory_order_relaxed);
  }
  BoundedQueue(const BoundedQueue&) = delete;
  BoundedQueue& operator=(const BoundedQueue&) = delete;

  /// Any thread. False when the queue is full; `value` is then lost to the queue, not to the caller.
  [[nodiscard]] bool push(const T& value) noexcept {
    std::size_t at = tail_.load(std::memory_order_relaxed);
    for (;;) {
      Cell& cell = cells_[at % Capacity];
      const auto lead = static_cast<std::ptrdiff_t>(cell.sequence.load(std::memory_order_acquire) - at);
      if (lead < 0) return false;
      if (lead > 0) {
        at = tail_.load(std::memory_order_relaxed);
      } else if (tail_.compare_exchange_weak(at, at + 1, std::memory_order_relaxed)) {
        cell.value = value;
        cell.sequence.store(at + 1, std::memory_order_release);
        return true;
      }
    }
  }

  /// The reader's thread only. Nothing when the queue is empty.
  [[nodiscard]] std::optional<T> pop() noexcept {
    Cell& cell = cells_[head_ % Capacity];
    if (cell.sequence.load(std::memory_order_acquire) != head_ + 1) return std::nullopt;
    std::optional<T> value(std::move(cell.value));
    cell.sequence.store(head_ + Capacity, std::memory_order_release);
    ++head_;
    return value;
  }

 private:
  struct Cell {
    std::atomic<std::size_t> sequence;
    T value{};
  };
  std::array<Cell, Capacity> cells_;
  std::atomic<std::size_t> tail_{0};
  std::size_t head_ = 0;  // reader's thread only
};

}  // namespace mirrorarm
