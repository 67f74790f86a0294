#include "core/simulation/simulated_cameras.h"

#include <algorithm>

#include "core/common/wait_until.h"
#include "core/simulation/counter_random.h"

namespace mirrorarm::simulation {

SimulatedCameras::SimulatedCameras(const camera::StereoRig& rig, const LightSettings& light,
                                   const SensorSettings& sensor, const CameraTiming& timing, World world,
                                   const TimeSource& time, std::uint64_t seed)
    : renderer_(rig, light, sensor),
      timing_(timing),
      world_(std::move(world)),
      time_(time),
      start_(time.now()),
      seed_(seed) {}

TimePoint SimulatedCameras::triggered(std::uint64_t sequence) const {
  return start_ + toClock(Seconds(static_cast<double>(sequence) / timing_.rate_hz));
}

TimePoint SimulatedCameras::ready(std::uint64_t sequence) const {
  return triggered(sequence) + toClock(timing_.exposure + timing_.transfer);
}

std::uint64_t SimulatedCameras::newestReady(TimePoint now) const {
  const double since_s = secondsBetween(ready(next_), now);
  auto newest = next_ + static_cast<std::uint64_t>(std::max(since_s * timing_.rate_hz, 0.0));
  while (newest > next_ && ready(newest) > now) --newest;  // rounding
  while (ready(newest + 1) <= now) ++newest;
  return newest;
}

Expected<camera::StereoFrame, camera::NoFrame> SimulatedCameras::next(Seconds timeout) {
  const Seconds patience = timing_.waits ? timeout : Seconds(0.0);
  const bool failed = failed_.load(std::memory_order_relaxed);
  const bool due = waitUntil(time_, failed ? TimePoint::max() : ready(next_), patience);
  if (!due || failed_.load(std::memory_order_relaxed)) return unexpected(camera::NoFrame::kTimeout);
  const std::uint64_t sequence = newestReady(time_.now());
  next_ = sequence + 1;
  return render(sequence);
}

camera::StereoFrame SimulatedCameras::render(std::uint64_t sequence) {
  const TimePoint middle = triggered(sequence) + toClock(0.5 * timing_.exposure);
  for (std::size_t i = 0; i < instants_.size(); ++i)
    world_(middle + toClock(kInstants[i] * timing_.exposure), instants_[i]);
  auto [left, right] = renderer_.render(instants_, counterRandom(seed_, sequence));
  return {std::move(left), std::move(right), middle + toClock(timing_.clock_ahead), timing_.exposure,
          sequence};
}

}  // namespace mirrorarm::simulation
