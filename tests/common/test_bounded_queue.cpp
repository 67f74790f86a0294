#include <array>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "core/common/bounded_queue.h"

using namespace mirrorarm;

TEST(BoundedQueue, KeepsTheOrderAndRefusesWhenFull) {
  BoundedQueue<int, 4> queue;
  EXPECT_FALSE(queue.pop());
  for (int turn = 0; turn < 3; ++turn) {
    for (int i = 0; i < 4; ++i) EXPECT_TRUE(queue.push(i));
    EXPECT_FALSE(queue.push(99));
    for (int i = 0; i < 4; ++i) EXPECT_EQ(queue.pop(), i);
    EXPECT_FALSE(queue.pop());
  }
}

TEST(BoundedQueue, LosesAndDoublesNothingFromSeveralWriters) {
  struct Item {
    int writer = 0;
    int number = 0;
  };
  constexpr int kWriters = 3, kItems = 20'000;
  BoundedQueue<Item, 64> queue;
  std::vector<std::jthread> writers;
  for (int w = 0; w < kWriters; ++w)
    writers.emplace_back([&queue, w] {
      for (int n = 0; n < kItems; ++n)
        while (!queue.push({w, n})) std::this_thread::yield();
    });
  std::array<int, kWriters> next{};
  for (int taken = 0; taken < kWriters * kItems;) {
    const auto item = queue.pop();
    if (!item) {
      std::this_thread::yield();
      continue;
    }
    ASSERT_EQ(item->number, next[static_cast<std::size_t>(item->writer)]++);
    ++taken;
  }
  EXPECT_FALSE(queue.pop());
}
