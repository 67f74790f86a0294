#include <gtest/gtest.h>

#include "core/common/ring_log.h"

using namespace mirrorarm;

TEST(RingLog, KeepsTheLastEntriesOldestFirst) {
  RingLog<int, 4> log;
  EXPECT_EQ(log.size(), 0u);
  log.add(1);
  log.add(2);
  ASSERT_EQ(log.size(), 2u);
  EXPECT_EQ(log[0], 1);
  EXPECT_EQ(log[1], 2);
  for (int i = 3; i <= 11; ++i) log.add(i);
  ASSERT_EQ(log.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(log[i], static_cast<int>(8 + i));
}
