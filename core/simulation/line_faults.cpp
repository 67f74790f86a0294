#include "core/simulation/line_faults.h"

#include "core/simulation/counter_random.h"

namespace mirrorarm::simulation {

void FaultyLine::set(const LineFaults& faults) noexcept {
  lost_share_.store(faults.lost_share, std::memory_order_relaxed);
  late_share_.store(faults.late_share, std::memory_order_relaxed);
}

FaultyLine::Fate FaultyLine::next() noexcept {
  const double lost = lost_share_.load(std::memory_order_relaxed);
  const double late = late_share_.load(std::memory_order_relaxed);
  const double drawn = counterUniform(seed_, messages_++);
  if (drawn < lost) return Fate::kLost;
  return drawn < lost + late ? Fate::kLate : Fate::kArrives;
}

}  // namespace mirrorarm::simulation
