#include "benchmarks/robot/pause_witness.h"

#include <algorithm>
#include <pthread.h>
#include <sched.h>

#include "core/devices/real_time.h"

namespace mirrorarm::benchmarks::robot {
namespace {

constexpr int kAboveAll = devices::kServoPriority + 10;

}  // namespace

PauseWitness::PauseWitness(Seconds longest) : cores_(std::max(1u, std::thread::hardware_concurrency())) {
  for (Core& each : cores_) {
    each.lateness_us.reserve(static_cast<std::size_t>(1.1 * (longest / kPause)));
    each.pauses.reserve(100'000);
  }
  for (std::size_t core = 0; core < cores_.size(); ++core)
    threads_.emplace_back([this, core](const std::stop_token& stop) { watch(stop, core, cores_[core]); });
}

void PauseWitness::watch(const std::stop_token& stop, std::size_t core, Core& seen) {
  cpu_set_t only{};
  CPU_SET(core, &only);
  ::pthread_setaffinity_np(::pthread_self(), sizeof only, &only);
  static_cast<void>(devices::askForRealTime(kAboveAll));
  TimePoint due = Clock::now();
  while (!stop.stop_requested()) {
    due = std::max(due, Clock::now()) + toClock(kPause);
    std::this_thread::sleep_until(due);
    const TimePoint woke = Clock::now();
    seen.lateness_us.push_back(static_cast<float>(1e6 * secondsBetween(due, woke)));
    if (woke - due > kPause) seen.pauses.push_back({due, woke});
  }
}

void PauseWitness::end() { threads_.clear(); }

bool PauseWitness::sawPause(TimePoint from, TimePoint to) const {
  return std::any_of(cores_.begin(), cores_.end(), [&](const Core& core) {
    const auto first = std::lower_bound(core.pauses.begin(), core.pauses.end(), from,
                                        [](const Pause& pause, TimePoint time) { return pause.to < time; });
    return first != core.pauses.end() && first->from <= to;
  });
}

std::vector<double> PauseWitness::lateness_us() const {
  std::vector<double> all;
  for (const Core& core : cores_) all.insert(all.end(), core.lateness_us.begin(), core.lateness_us.end());
  return all;
}

}  // namespace mirrorarm::benchmarks::robot
