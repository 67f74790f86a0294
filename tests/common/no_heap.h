#pragma once

#include <cerrno>
#include <cstddef>
#include <cstdint>

/// Counts what the calling thread takes from the heap, through whatever door (operator new, Eigen, a C
/// library): it stands in for the C library's malloc. Include it in exactly ONE .cpp of a test program. Under
/// a sanitizer, which brings a malloc of its own, nothing is counted and `heapIsCounted` is false.
namespace mirrorarm::testing {

inline thread_local std::size_t heap_calls = 0;

/// How often the heap was asked while `work` ran.
template <class Work>
std::size_t heapCallsIn(Work&& work) {
  const std::size_t before = heap_calls;
  work();
  return heap_calls - before;
}

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool heapIsCounted = false;
#else
inline constexpr bool heapIsCounted = true;
#endif

}  // namespace mirrorarm::testing

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* old, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);

void* malloc(std::size_t size) noexcept {
  ++mirrorarm::testing::heap_calls;
  return __libc_malloc(size);
}

void* calloc(std::size_t count, std::size_t size) noexcept {
  ++mirrorarm::testing::heap_calls;
  return __libc_calloc(count, size);
}

void* realloc(void* old, std::size_t size) noexcept {
  ++mirrorarm::testing::heap_calls;
  return __libc_realloc(old, size);
}

void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  ++mirrorarm::testing::heap_calls;
  return __libc_memalign(alignment, size);
}

int posix_memalign(void** place, std::size_t alignment, std::size_t size) noexcept {
  ++mirrorarm::testing::heap_calls;
  *place = __libc_memalign(alignment, size);
  return *place == nullptr ? ENOMEM : 0;
}
}
#endif
