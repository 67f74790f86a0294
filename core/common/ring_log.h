#pragma once

#include <array>
#include <cstddef>

namespace mirrorarm {

/// The last `Capacity` entries, oldest overwritten: a black box. One thread; does not allocate.
template <class T, std::size_t Capacity>
class RingLog {
 public:
  void add(const T& entry) noexcept {
    entries_[next_] = entry;
    next_ = (next_ + 1) % Capacity;
    if (size_ < Capacity) ++size_;
  }

  [[nodiscard]] std::size_t size() const noexcept { return size_; }

  /// Entry `i`, 0 the oldest kept.
  [[nodiscard]] const T& operator[](std::size_t i) const noexcept {
    return entries_[(next_ + Capacity - size_ + i) % Capacity];
  }

 private:
  std::array<T, Capacity> entries_{};
  std::size_t next_ = 0;
  std::size_t size_ = 0;
};

}  // namespace mirrorarm
