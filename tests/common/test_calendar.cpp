#include <gtest/gtest.h>

#include "core/common/calendar.h"

namespace mirrorarm {
namespace {

using namespace std::chrono_literals;

TEST(Calendar, ReadsWhatItWrites) {
  const auto now = std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
  EXPECT_EQ(timeOfIsoUtc(isoUtc(now)), now);
  EXPECT_EQ(timeOfIsoUtc("2026-01-31T09:05:00Z"),
            std::chrono::sys_days(std::chrono::January / 31 / 2026) + 9h + 5min);
  EXPECT_EQ(timeOfIsoUtc("2026-01-31"), std::chrono::sys_days(std::chrono::January / 31 / 2026));
  for (const auto* text : {"", "yesterday", "2026-02-30", "2026-01-31T25:00:00Z", "2026-01-31T09:05:00",
                           "2026-01-31 09:05:00Z", "20260131", "2026-1-31", "-026-01-31"})
    EXPECT_FALSE(timeOfIsoUtc(text)) << text;
}

}  // namespace
}  // namespace mirrorarm
