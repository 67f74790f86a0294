#pragma once

#include <atomic>
#include <cstddef>

/// Counts what a thread, or all of them, takes from the heap, through whatever door (operator new, Eigen, a C
/// library). Add tests/common/no_heap.cpp, which stands in for the C library's malloc, to the test program.
namespace mirrorarm::testing {

/// A sanitizer brings a malloc of its own: then nothing is counted.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool heapIsCounted = false;
#else
inline constexpr bool heapIsCounted = true;
#endif

inline thread_local std::size_t heap_calls = 0;
inline std::atomic<std::size_t> heap_calls_of_all_threads{0};

/// How often the calling thread asked the heap while `work` ran.
template <class Work>
std::size_t heapCallsIn(Work&& work) {
  const std::size_t before = heap_calls;
  work();
  return heap_calls - before;
}

/// How often any thread asked the heap while `work` ran.
template <class Work>
std::size_t heapCallsOfAllThreadsIn(Work&& work) {
  const std::size_t before = heap_calls_of_all_threads;
  work();
  return heap_calls_of_all_threads - before;
}

}  // namespace mirrorarm::testing
