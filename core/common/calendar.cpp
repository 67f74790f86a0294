#include "core/common/calendar.h"

#include <array>
#include <charconv>
#include <ctime>
#include <system_error>

namespace mirrorarm {
namespace {

constexpr std::size_t kDateLength = std::string_view("2026-01-31").size();

/// Digits alone.
std::optional<unsigned> number(std::string_view digits) {
  unsigned value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  return error == std::errc() && end == digits.data() + digits.size() ? std::optional(value) : std::nullopt;
}

std::optional<std::chrono::year_month_day> dateOf(std::string_view text) {
  if (text.size() != kDateLength || text[4] != '-' || text[7] != '-') return std::nullopt;
  const auto year = number(text.substr(0, 4)), month = number(text.substr(5, 2)),
             day = number(text.substr(8, 2));
  if (!year || !month || !day) return std::nullopt;
  const std::chrono::year_month_day date(std::chrono::year(static_cast<int>(*year)),
                                         std::chrono::month(*month), std::chrono::day(*day));
  return date.ok() ? std::optional(date) : std::nullopt;
}

/// "T09:05:00Z"
std::optional<std::chrono::seconds> timeOfDay(std::string_view text) {
  if (text.size() != 10 || text[0] != 'T' || text[3] != ':' || text[6] != ':' || text[9] != 'Z')
    return std::nullopt;
  const auto hours = number(text.substr(1, 2)), minutes = number(text.substr(4, 2)),
             seconds = number(text.substr(7, 2));
  if (!hours || !minutes || !seconds || *hours > 23 || *minutes > 59 || *seconds > 60) return std::nullopt;
  return std::chrono::hours(*hours) + std::chrono::minutes(*minutes) + std::chrono::seconds(*seconds);
}

}  // namespace

std::string isoUtc(std::chrono::system_clock::time_point moment) {
  const std::time_t seconds = std::chrono::system_clock::to_time_t(moment);
  std::tm utc{};
  ::gmtime_r(&seconds, &utc);
  std::array<char, 32> text{};
  const auto length = std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &utc);
  return {text.data(), length};
}

std::string isoUtcNow() { return isoUtc(std::chrono::system_clock::now()); }

std::optional<std::chrono::system_clock::time_point> timeOfIsoUtc(std::string_view text) {
  const auto day = dateOf(text.substr(0, kDateLength));
  if (!day) return std::nullopt;
  if (text.size() == kDateLength) return std::chrono::sys_days(*day);
  const auto time = timeOfDay(text.substr(kDateLength));
  if (!time) return std::nullopt;
  return std::chrono::sys_days(*day) + *time;
}

}  // namespace mirrorarm
