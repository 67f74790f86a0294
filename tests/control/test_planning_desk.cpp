#include <thread>

#include <gtest/gtest.h>

#include "core/control/planning_desk.h"
#include "tests/robot/arms.h"

namespace mirrorarm::control {
namespace {

using robot::Joints;

constexpr TimePoint kNow{std::chrono::hours(1)};

robot::Planner planner() { return {robot::testing::lbr(), {}, {}, {}}; }

TEST(PlanningDesk, AnswersTheNewestQuestionWithItsNumber) {
  PlanningDesk desk(planner());
  desk.answer();
  EXPECT_EQ(desk.takeAnswer(), nullptr) << "nobody asked";
  const Joints from = robot::testing::working(), to = from + Joints::Constant(7, 0.05);
  desk.ask({.number = 1, .from = from, .to = from}, kNow);
  desk.ask({.number = 2, .from = from, .to = to}, kNow);
  desk.answer();
  const PlanAnswer* answer = desk.takeAnswer();
  ASSERT_NE(answer, nullptr);
  EXPECT_EQ(answer->number, 2U);
  EXPECT_FALSE(answer->refusal);
  ASSERT_FALSE(answer->path().empty());
  EXPECT_EQ(answer->path().back(), to);
  EXPECT_EQ(desk.takeAnswer(), nullptr) << "each answer is given once";
}

TEST(PlanningDesk, TellsHowLongItHasBeenAsked) {
  PlanningDesk desk(planner());
  EXPECT_EQ(desk.waiting(kNow).count(), 0.0);
  const Joints from = robot::testing::working();
  desk.ask({.number = 1, .from = from, .to = from}, kNow);
  desk.answer();
  desk.ask({.number = 2, .from = from, .to = from}, kNow + std::chrono::seconds(1));
  ASSERT_NE(desk.takeAnswer(), nullptr);
  EXPECT_EQ(desk.waiting(kNow + std::chrono::seconds(3)).count(), 2.0) << "an older answer is not this one's";
  desk.answer();
  ASSERT_NE(desk.takeAnswer(), nullptr);
  EXPECT_EQ(desk.waiting(kNow + std::chrono::seconds(3)).count(), 0.0);
}

TEST(PlanningDesk, SaysWhyThereIsNoWay) {
  PlanningDesk desk(planner());
  const Joints from = robot::testing::working();
  desk.ask({.number = 7, .from = from, .to = Joints::Constant(7, 9.0)}, kNow);
  desk.answer();
  const PlanAnswer* answer = desk.takeAnswer();
  ASSERT_NE(answer, nullptr);
  ASSERT_TRUE(answer->refusal);
  EXPECT_EQ(answer->refusal->why, robot::PlanError::kGoalBlocked);
}

TEST(PlanningDesk, AnswersFromAThreadOfItsOwn) {
  PlanningDesk desk(planner());
  std::jthread planning([&](const std::stop_token& stop) {
    while (!stop.stop_requested()) desk.awaitAndAnswer(Seconds(0.01));
  });
  const Joints from = robot::testing::working();
  desk.ask({.number = 3, .from = from, .to = from + Joints::Constant(7, 0.1)}, kNow);
  const PlanAnswer* answer = nullptr;
  for (int i = 0; i < 2000 && answer == nullptr; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    answer = desk.takeAnswer();
  }
  ASSERT_NE(answer, nullptr);
  EXPECT_EQ(answer->number, 3U);
}

}  // namespace
}  // namespace mirrorarm::control
