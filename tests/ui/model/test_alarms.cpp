#include <gtest/gtest.h>

#include "tests/ui/fake_bench.h"
#include "ui/model/alarm_list.h"

namespace mirrorarm::ui {
namespace {

const Condition kStop{QStringLiteral("stop"), Priority::kHigh, QStringLiteral("Stopped")};
const Condition kReach{QStringLiteral("reach"), Priority::kLow, QStringLiteral("Out of reach")};

TEST(AlarmList, AnAlarmStaysUntilItIsOverAndAcknowledged) {
  AlarmList alarms;
  alarms.update({kStop});
  alarms.acknowledge();
  EXPECT_EQ(alarms.alarms().size(), 1) << "its condition still holds";
  alarms.update({});
  EXPECT_TRUE(alarms.alarms().isEmpty());

  alarms.update({kStop});
  alarms.update({});
  ASSERT_EQ(alarms.alarms().size(), 1) << "nobody has seen it";
  EXPECT_FALSE(alarms.alarms().first().active);
  alarms.acknowledge();
  EXPECT_TRUE(alarms.alarms().isEmpty());
}

TEST(AlarmList, AnAlarmThatComesAgainMustBeAcknowledgedAgain) {
  AlarmList alarms;
  int raised = 0;
  QObject::connect(&alarms, &AlarmList::raised, [&raised] { ++raised; });
  alarms.update({kStop});
  alarms.update({kStop});
  alarms.update({});
  alarms.update({kStop});
  EXPECT_EQ(raised, 2);
  EXPECT_TRUE(alarms.needsAcknowledging());
  EXPECT_EQ(alarms.alarms().size(), 1);
}

TEST(AlarmList, TheMostUrgentComesFirst) {
  AlarmList alarms;
  alarms.update({kReach});
  alarms.update({kReach, kStop});
  EXPECT_EQ(alarms.alarms().first().condition, kStop);
  alarms.update({kReach});
  EXPECT_EQ(alarms.alarms().first().condition, kReach) << "what is over stands behind what holds";
}

class Conditions : public ::testing::Test {
 protected:
  test::FakeStation station_{test::benchWorkplace()};
  QVector<Condition> now() { return conditionsOf(station_.snapshot(), Clock::now()); }
};

TEST_F(Conditions, AHealthyBenchRaisesNone) {
  EXPECT_TRUE(now().isEmpty());
  station_.enter(therapy::Phase::kTraining);
  EXPECT_TRUE(now().isEmpty());
}

TEST_F(Conditions, ASilentCameraAndRobotAreHigh) {
  (void)station_.snapshot();
  station_.frozen = true;
  const auto found = conditionsOf(station_.snapshot(), Clock::now() + std::chrono::seconds(1));
  ASSERT_EQ(found.size(), 2);
  EXPECT_EQ(found[0].priority, Priority::kHigh);
  EXPECT_EQ(found[1].priority, Priority::kHigh);
}

TEST_F(Conditions, AStopThatTheOperatorWishedIsLessUrgentThanAFault) {
  station_.stop(control::StopReason::kOperator);
  EXPECT_EQ(now().first().priority, Priority::kMedium);
  station_.stop(control::StopReason::kFollowingError);
  EXPECT_EQ(now().first().priority, Priority::kHigh);
}

TEST_F(Conditions, ATargetOutOfViewMattersOnlyWhileTraining) {
  station_.enter(therapy::Phase::kAligned);
  station_.shown.control.target_fresh = false;
  EXPECT_TRUE(now().isEmpty());
  station_.enter(therapy::Phase::kTraining);
  station_.shown.control.target_fresh = false;
  ASSERT_EQ(now().size(), 1);
  EXPECT_EQ(now().first().priority, Priority::kLow) << "the stop that may follow is the high one";
}

TEST_F(Conditions, WhatStandsInTheWayIsNamed) {
  station_.enter(therapy::Phase::kTraining);
  station_.shown.control.follow = control::FollowOutcome::kBlocked;
  station_.shown.control.contact =
      robot::Contact{robot::ArmPart::kSling, robot::ObstacleKind::kHead, "patient"};
  ASSERT_EQ(now().size(), 1);
  EXPECT_TRUE(now().first().text.contains(QStringLiteral("The sling"))) << qPrintable(now().first().text);
  EXPECT_TRUE(now().first().text.contains(QStringLiteral("head")));
}

TEST_F(Conditions, AnArmThatStaysBehindToKeepTheTargetInViewIsTold) {
  station_.enter(therapy::Phase::kTraining);
  station_.shown.control.gaze_kept = true;
  ASSERT_EQ(now().size(), 1);
  EXPECT_EQ(now().first().priority, Priority::kLow);
}

}  // namespace
}  // namespace mirrorarm::ui
