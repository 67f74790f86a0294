#include <algorithm>
#include <set>
#include <string_view>

#include <gtest/gtest.h>

#include "core/therapy/session_phase.h"

namespace mirrorarm::therapy {
namespace {

constexpr Phase kPhases[] = {Phase::kPrepare,  Phase::kTeaching, Phase::kTaught,  Phase::kAligned,
                             Phase::kTraining, Phase::kPaused,   Phase::kFinished};
constexpr Action kActions[] = {Action::kTeach, Action::kFinishTeaching, Action::kAlign,     Action::kStart,
                               Action::kPause, Action::kFinish,         Action::kNewSession};

TEST(SessionPhase, TheUsualWayLeadsThroughEveryPhase) {
  Phase phase = Phase::kPrepare;
  for (const auto action : {Action::kTeach, Action::kFinishTeaching, Action::kAlign, Action::kStart,
                            Action::kPause, Action::kStart, Action::kFinish, Action::kNewSession}) {
    const auto next = after(phase, action);
    ASSERT_TRUE(next) << id(phase) << " + " << id(action);
    phase = *next;
  }
  EXPECT_EQ(phase, Phase::kPrepare);
}

TEST(SessionPhase, TheRobotMovesOnlyAfterAligningAndOnlyByStart) {
  for (const auto phase : kPhases)
    for (const auto action : kActions)
      if (after(phase, action) == Phase::kTraining) {
        EXPECT_EQ(action, Action::kStart);
        EXPECT_TRUE(phase == Phase::kAligned || phase == Phase::kPaused);
      }
}

TEST(SessionPhase, ABegunSessionIsFinishedBeforeTheNext) {
  for (const auto phase : {Phase::kTraining, Phase::kPaused}) {
    EXPECT_FALSE(after(phase, Action::kNewSession));
    EXPECT_FALSE(after(phase, Action::kTeach));
    EXPECT_EQ(after(phase, Action::kFinish), Phase::kFinished);
  }
}

TEST(SessionPhase, WhatMakesNoSenseIsRefused) {
  EXPECT_FALSE(after(Phase::kPrepare, Action::kStart));
  EXPECT_FALSE(after(Phase::kTaught, Action::kStart));
  EXPECT_FALSE(after(Phase::kTeaching, Action::kAlign));
  EXPECT_FALSE(after(Phase::kTraining, Action::kStart));
  EXPECT_FALSE(after(Phase::kFinished, Action::kStart));
}

TEST(SessionPhase, NoPhaseIsADeadEndAndNamesAreUnique) {
  std::set<std::string_view> names;
  for (const auto phase : kPhases) {
    names.insert(id(phase));
    EXPECT_TRUE(
        std::ranges::any_of(kActions, [&](Action action) { return after(phase, action).has_value(); }));
  }
  EXPECT_EQ(names.size(), std::size(kPhases));
  names.clear();
  for (const auto action : kActions) names.insert(id(action));
  EXPECT_EQ(names.size(), std::size(kActions));
}

}  // namespace
}  // namespace mirrorarm::therapy
