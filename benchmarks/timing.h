#pragma once

#include <vector>

#include "benchmarks/statistics.h"
#include "core/common/time.h"

namespace mirrorarm::benchmarks {

/// What one call of something costs.
struct Timing {
  double median_ms = 0.0;
  double p99_ms = 0.0;
};

/// Calls `work(i)` for 0 .. count - 1 one after the other.
template <class Work>
[[nodiscard]] Timing timed(int count, Work work) {
  std::vector<double> times_ms;
  times_ms.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    const TimePoint start = Clock::now();
    work(i);
    times_ms.push_back(1000.0 * secondsBetween(start, Clock::now()));
  }
  return {quantile(times_ms, 0.5), quantile(times_ms, 0.99)};
}

}  // namespace mirrorarm::benchmarks
