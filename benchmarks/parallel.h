#pragma once

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace mirrorarm::benchmarks {

/// Calls `makeWorker()` once a core and what it returns as `worker(int trial)` for 0 .. count - 1, each trial
/// once, in no particular order. A worker keeps its own buffers; results go to places of their own. What a
/// worker throws comes out here.
template <class MakeWorker>
void forEachTrial(int count, MakeWorker makeWorker) {
  std::atomic<int> next{0};
  std::exception_ptr failure;
  std::mutex guard;  // of failure
  const auto work = [&] {
    try {
      auto worker = makeWorker();
      for (int trial = next++; trial < count; trial = next++) worker(trial);
    } catch (...) {
      const std::scoped_lock lock(guard);
      failure = std::current_exception();
      next = count;
    }
  };
  {
    std::vector<std::jthread> threads;
    for (unsigned i = 0; i < std::max(1U, std::thread::hardware_concurrency()); ++i)
      threads.emplace_back(work);
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace mirrorarm::benchmarks
