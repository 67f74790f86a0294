#pragma once

#include <chrono>
#include <string>

namespace mirrorarm {

/// A moment as ISO 8601 in UTC to the second, "2026-01-31T09:05:00Z", as records and files write it.
[[nodiscard]] std::string isoUtc(std::chrono::system_clock::time_point moment);

/// The same for now. For records only; decisions read a TimeSource.
[[nodiscard]] std::string isoUtcNow();

}  // namespace mirrorarm
