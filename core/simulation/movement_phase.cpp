#include "core/simulation/movement_phase.h"

#include <algorithm>

#include "core/simulation/smooth_ramp.h"

namespace mirrorarm::simulation {
namespace {

constexpr double kRamp_s = 0.5;

}  // namespace

double MovementPhase::speedAfter(const Switch& from, double elapsed_s) {
  return from.speed + (from.target - from.speed) * smoothRamp(elapsed_s / kRamp_s);
}

double MovementPhase::phaseAfter(const Switch& from, double elapsed_s) {
  return from.phase_s + from.speed * elapsed_s +
         (from.target - from.speed) * kRamp_s * smoothRampIntegral(elapsed_s / kRamp_s);
}

void MovementPhase::set(TimePoint time, bool moving) {
  const std::lock_guard lock(mutex_);
  const double target = moving ? 1.0 : 0.0;
  const Switch last = switches_.empty() ? Switch{time, 0.0, 0.0, 0.0} : switches_.back();
  if (last.target == target) return;
  const double elapsed_s = std::max(secondsBetween(last.time, time), 0.0);
  switches_.push_back({time, phaseAfter(last, elapsed_s), speedAfter(last, elapsed_s), target});
}

double MovementPhase::at(TimePoint time) const {
  const std::lock_guard lock(mutex_);
  const auto after = std::upper_bound(switches_.begin(), switches_.end(), time,
                                      [](TimePoint t, const Switch& entry) { return t < entry.time; });
  if (after == switches_.begin()) return 0.0;
  const Switch& from = *(after - 1);
  return phaseAfter(from, secondsBetween(from.time, time));
}

}  // namespace mirrorarm::simulation
