#pragma once

#include <chrono>

namespace mirrorarm {

/// The only clock used for decisions: it never jumps. Calendar time belongs to records alone.
using Clock = std::chrono::steady_clock;
using TimePoint = Clock::time_point;
using Seconds = std::chrono::duration<double>;

/// `seconds` as the clock's own duration, for arithmetic with a TimePoint.
[[nodiscard]] constexpr Clock::duration toClock(Seconds seconds) {
  return std::chrono::duration_cast<Clock::duration>(seconds);
}

/// Seconds from `from` to `to`; negative when `to` is earlier.
[[nodiscard]] constexpr double secondsBetween(TimePoint from, TimePoint to) {
  return Seconds(to - from).count();
}

/// Nanoseconds since the clock's epoch, as the file formats write a time.
[[nodiscard]] constexpr long long toNanoseconds(TimePoint time) {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(time.time_since_epoch()).count();
}

/// The time that `nanoseconds` since the clock's epoch stand for.
[[nodiscard]] constexpr TimePoint fromNanoseconds(long long nanoseconds) {
  return TimePoint(std::chrono::duration_cast<Clock::duration>(std::chrono::nanoseconds(nanoseconds)));
}

}  // namespace mirrorarm
