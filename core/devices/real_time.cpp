#include "core/devices/real_time.h"

#include <cerrno>
#include <cstddef>
#include <cstring>
#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

namespace mirrorarm::devices {
namespace {

constexpr std::size_t kStackInUse = 128 * 1024;

/// A limit would let the lock succeed now and an allocation fail later.
bool mayLockEverything() {
  rlimit limit{};
  return ::geteuid() == 0 || (::getrlimit(RLIMIT_MEMLOCK, &limit) == 0 && limit.rlim_cur == RLIM_INFINITY);
}

/// Locked pages count from their first use: the thread's stack is used now, not in its loop.
void useStack() {
  [[maybe_unused]] volatile std::byte stack[kStackInUse];
  const long page = ::sysconf(_SC_PAGESIZE);
  for (std::size_t i = 0; i < kStackInUse; i += static_cast<std::size_t>(page)) stack[i] = std::byte{0};
}

int lockMemory() {
  if (!mayLockEverything()) return EPERM;
  if (::mlockall(MCL_CURRENT | MCL_FUTURE | MCL_ONFAULT) != 0) return errno;
  useStack();
  return 0;
}

}  // namespace

RealTimeGrant askForRealTime(int priority) noexcept {
  sched_param parameters{};
  parameters.sched_priority = priority;
  return {::pthread_setschedparam(::pthread_self(), SCHED_FIFO, &parameters), lockMemory()};
}

std::string schedulingLine(const RealTimeGrant& grant) {
  if (grant.scheduling_error == 0) return "SCHED_FIFO is granted";
  return std::string("SCHED_FIFO refused (") + std::strerror(grant.scheduling_error) +
         "): add '@realtime - rtprio 90' to /etc/security/limits.conf";
}

std::string memoryLine(const RealTimeGrant& grant) {
  if (grant.memory_error == 0) return "memory is locked: nothing is paged out";
  return std::string("memory cannot be locked (") + std::strerror(grant.memory_error) +
         "): add '@realtime - memlock unlimited' to /etc/security/limits.conf";
}

}  // namespace mirrorarm::devices
