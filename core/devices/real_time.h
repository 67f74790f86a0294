#pragma once

#include <string>

namespace mirrorarm::devices {

/// Below the kernel's own threads for interrupts, above everything of ours.
inline constexpr int kServoPriority = 40;

/// What the system let a thread have.
struct RealTimeGrant {
  int scheduling_error = 0;  ///< 0: it runs under SCHED_FIFO; else errno's reason
  int memory_error = 0;      ///< 0: the program's memory stays in RAM; else errno's reason
  [[nodiscard]] bool isFull() const { return scheduling_error == 0 && memory_error == 0; }
};

/// Asks for SCHED_FIFO for the calling thread, and for memory that is never paged out for the whole program.
/// Memory is only locked where no limit could make a later allocation fail. Once, before the thread's loop.
[[nodiscard]] RealTimeGrant askForRealTime(int priority = kServoPriority) noexcept;

/// One line a person can act on: what was granted, and what to do where it was not.
[[nodiscard]] std::string schedulingLine(const RealTimeGrant& grant);
[[nodiscard]] std::string memoryLine(const RealTimeGrant& grant);

}  // namespace mirrorarm::devices
