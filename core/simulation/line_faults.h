#pragma once

#include <atomic>
#include <cstdint>

namespace mirrorarm::simulation {

/// How badly a line to a robot carries messages.
struct LineFaults {
  double lost_share = 0.0;  ///< of the messages in either direction, 0 to 1
  double late_share = 0.0;  ///< of the answers: the one before comes once more instead
};

/// Decides of each message what becomes of it, the same for the same seed. One thread, set() from any.
class FaultyLine {
 public:
  enum class Fate { kArrives, kLost, kLate };

  explicit FaultyLine(std::uint64_t seed) : seed_(seed) {}

  void set(const LineFaults& faults) noexcept;
  [[nodiscard]] Fate next() noexcept;

 private:
  const std::uint64_t seed_;
  std::atomic<double> lost_share_{0.0}, late_share_{0.0};
  std::uint64_t messages_ = 0;
};

}  // namespace mirrorarm::simulation
