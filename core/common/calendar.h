#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

namespace mirrorarm {

/// A moment as ISO 8601 in UTC to the second, "2026-01-31T09:05:00Z", as records and files write it.
[[nodiscard]] std::string isoUtc(std::chrono::system_clock::time_point moment);

/// The same for now. For records only; decisions read a TimeSource.
[[nodiscard]] std::string isoUtcNow();

/// The moment of such a text, or of its day alone ("2026-01-31", midnight). Nothing for anything else.
[[nodiscard]] std::optional<std::chrono::system_clock::time_point> timeOfIsoUtc(std::string_view text);

}  // namespace mirrorarm
