#pragma once

#include <cstddef>
#include <thread>
#include <vector>

#include "core/common/time.h"

namespace mirrorarm::benchmarks::robot {

/// An idle thread on each core, above every thread of ours in rank, that wakes four times a millisecond: when
/// it wakes late the core was not ours, whoever had it (the hypervisor, an interrupt).
class PauseWitness {
 public:
  /// Wake-ups that are later than this are kept as pauses; as long as the beat, so that none slips through.
  static constexpr Seconds kPause{250e-6};

  explicit PauseWitness(Seconds longest);

  /// Ends the threads; then the rest may be asked.
  void end();
  /// Whether any core paused between two times.
  [[nodiscard]] bool sawPause(TimePoint from, TimePoint to) const;
  /// How late each wake-up was, of all cores.
  [[nodiscard]] std::vector<double> lateness_us() const;

 private:
  struct Pause {
    TimePoint from{}, to{};
  };
  struct Core {
    std::vector<Pause> pauses;
    std::vector<float> lateness_us;
  };
  static void watch(const std::stop_token& stop, std::size_t core, Core& seen);

  std::vector<Core> cores_;
  std::vector<std::jthread> threads_;  // last member: joined first
};

}  // namespace mirrorarm::benchmarks::robot
