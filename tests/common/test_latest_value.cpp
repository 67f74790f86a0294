#include <array>
#include <thread>

#include <gtest/gtest.h>

#include "core/common/latest_value.h"

using namespace mirrorarm;

TEST(LatestValue, GivesTheNewestOnceAndCountsWhatWasNotRead) {
  LatestValue<int> box;
  EXPECT_EQ(box.take(), nullptr);
  EXPECT_FALSE(box.put(1));
  EXPECT_TRUE(box.put(2));
  const int* newest = box.take();
  ASSERT_NE(newest, nullptr);
  EXPECT_EQ(*newest, 2);
  EXPECT_EQ(box.take(), nullptr);
  EXPECT_FALSE(box.put(3));
}

TEST(LatestValue, AReadValueStaysGoodUntilTheNextTake) {
  LatestValue<int> box;
  (void)box.put(1);
  const int* held = box.take();
  for (int i = 2; i < 10; ++i) (void)box.put(i);
  EXPECT_EQ(*held, 1);
  EXPECT_EQ(*box.take(), 9);
}

TEST(LatestValue, ReaderSeesWholeValuesThatRiseAndTheLastOne) {
  struct Wide {
    std::array<long, 32> copies{};
  };
  constexpr long kLast = 100'000;
  LatestValue<Wide> box;
  std::jthread writer([&box] {
    Wide value;
    for (long i = 1; i <= kLast; ++i) {
      value.copies.fill(i);
      (void)box.put(value);
    }
  });
  for (long last = 0; last < kLast;) {
    const Wide* value = box.take();
    if (value == nullptr) {
      std::this_thread::yield();
      continue;
    }
    ASSERT_GT(value->copies.front(), last);
    last = value->copies.front();
    for (const long copy : value->copies) ASSERT_EQ(copy, last);
  }
}
