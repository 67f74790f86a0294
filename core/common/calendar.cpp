#include "core/common/calendar.h"

#include <array>
#include <ctime>

namespace mirrorarm {

std::string isoUtc(std::chrono::system_clock::time_point moment) {
  const std::time_t seconds = std::chrono::system_clock::to_time_t(moment);
  std::tm utc{};
  ::gmtime_r(&seconds, &utc);
  std::array<char, 32> text{};
  const auto length = std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &utc);
  return {text.data(), length};
}

std::string isoUtcNow() { return isoUtc(std::chrono::system_clock::now()); }

}  // namespace mirrorarm
