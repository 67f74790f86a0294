#include <gtest/gtest.h>

#include "tests/ui/fake_bench.h"
#include "ui/model/help_presenter.h"
#include "ui/model/journal.h"
#include "ui/model/readiness.h"
#include "ui/model/robot_presenter.h"
#include "ui/model/session_presenter.h"
#include "ui/model/summary.h"
#include "ui/model/tracking_presenter.h"
#include "ui/model/words.h"

namespace mirrorarm::ui {
namespace {

using therapy::Action;
using therapy::Phase;

class Presenters : public ::testing::Test {
 protected:
  Workplace workplace_ = test::benchWorkplace();
  test::FakeStation station_{workplace_};
  SessionPresenter session_{station_};
  void beat() { session_.show(station_.snapshot()); }
};

TEST_F(Presenters, TheSessionLeadsThroughItsSteps) {
  const std::vector<std::pair<Step, std::optional<Action>>> way{{Step::kPrepare, Action::kTeach},
                                                                {Step::kTeach, Action::kFinishTeaching},
                                                                {Step::kAlign, Action::kAlign},
                                                                {Step::kTrain, Action::kStart},
                                                                {Step::kTrain, Action::kPause}};
  for (const auto& [step, primary] : way) {
    beat();
    EXPECT_EQ(session_.state().step, step);
    ASSERT_EQ(session_.state().primary, primary);
    EXPECT_TRUE(session_.state().allows(*primary));
    session_.ask(*primary);
  }
  beat();
  session_.ask(Action::kFinish);
  beat();
  EXPECT_EQ(session_.state().step, Step::kReport);
  EXPECT_TRUE(session_.state().can_report);
}

TEST_F(Presenters, WhatThePhaseForbidsIsNotAllowed) {
  beat();
  EXPECT_FALSE(session_.state().allows(Action::kStart));
  session_.ask(Action::kStart);
  beat();
  EXPECT_EQ(session_.state().message, words(station::Answer::kNotNow));
  session_.ask(Action::kTeach);
  beat();
  EXPECT_TRUE(session_.state().message.isEmpty()) << "an accepted wish clears the refusal";
}

TEST_F(Presenters, ARefusalAtOnceIsToldAtOnce) {
  station_.answer = station::Answer::kQueueFull;
  session_.ask(Action::kTeach);
  EXPECT_EQ(session_.state().message, words(station::Answer::kQueueFull));
}

TEST_F(Presenters, AStopLeavesItsResetAndTheEndOfTheSession) {
  station_.enter(Phase::kTraining);
  beat();
  session_.stop();
  EXPECT_EQ(station_.stops, 1);
  beat();
  EXPECT_TRUE(session_.state().stopped);
  EXPECT_EQ(session_.state().primary, std::nullopt);
  for (int i = 0; i < kActionCount; ++i) {
    const auto action = static_cast<Action>(i);
    EXPECT_EQ(session_.state().allows(action), action == Action::kFinish);
  }
  session_.resetStop();
  beat();
  EXPECT_FALSE(session_.state().stopped);
  EXPECT_EQ(session_.state().phase, Phase::kPaused) << "a reset starts nothing";
}

TEST_F(Presenters, AResetThatIsRefusedSaysWhy) {
  session_.stop();
  station_.shown.control.servo.reset = control::ResetRefusal::kMoving;
  beat();
  EXPECT_FALSE(session_.state().can_reset);
  EXPECT_FALSE(session_.state().message.isEmpty());
  station_.shown.control.servo.reset = control::ResetRefusal::kCausePersists;
  station_.shown.control.servo.lasting = control::StopReason::kCameraSilent;
  beat();
  EXPECT_TRUE(session_.state().message.contains(words(control::StopReason::kCameraSilent)));
  station_.shown.control.servo.reset = control::ResetRefusal::kNone;
  beat();
  EXPECT_TRUE(session_.state().can_reset);
  EXPECT_TRUE(session_.state().message.isEmpty());
}

TEST_F(Presenters, TheEnablingKeyReachesTheStationAndComesBackAsItCounts) {
  station_.shown.control.servo.enabling_needed = true;
  session_.setEnabling(control::EnablingPosition::kEnabled);
  beat();
  EXPECT_TRUE(session_.state().enabling_needed);
  EXPECT_EQ(session_.state().enabling, control::EnablingPosition::kEnabled);
}

TEST_F(Presenters, ForceHelpAndTheKindOfStopAreShown) {
  const auto figures = [&] {
    RobotPresenter robot(workplace_);
    robot.show(station_.snapshot(), Clock::now());
    return robot.figures();
  };
  EXPECT_EQ(figures().force, QStringLiteral("–")) << "a robot without torque sensors";
  auto& assist = station_.shown.control.servo.assist;
  assist.force = {true, {0.0, 0.0, -48.0}, 0.6, control::ForceLevel::kWarning};
  assist.gives_way = true;
  assist.level = 0.4;
  EXPECT_EQ(figures().force, QStringLiteral("48 N"));
  EXPECT_EQ(figures().help, QStringLiteral("40 %"));
  EXPECT_DOUBLE_EQ(figures().force_share, 0.6);
  station_.stop(control::StopReason::kOperator);
  const QString held = figures().motion;
  station_.stop(control::StopReason::kRobotSilent);
  EXPECT_NE(figures().motion, held) << "drives on, drives off";
}

TEST_F(Presenters, HelpCannotBeChosenWhereTheRobotHoldsItsPosition) {
  HelpPresenter help(station_);
  help.show(station_.snapshot());
  EXPECT_FALSE(help.state().can_change || help.state().can_lessen || help.state().can_raise);
  EXPECT_FALSE(help.state().reason.isEmpty());
  help.lessen();
  EXPECT_EQ(station_.shown.control.help, control::Help{});
  station_.answer = station::Answer::kQueueFull;
  QString refusal;
  QObject::connect(&help, &HelpPresenter::refused, [&](const QString& why) { refusal = why; });
  help.lessen();
  EXPECT_EQ(refusal, words(station::Answer::kQueueFull));
}

TEST_F(Presenters, HelpIsChosenInStepsAndFixedWhereItHasAdaptedTo) {
  HelpPresenter help(station_);
  const auto& wanted = station_.shown.control.help;
  auto& assist = station_.shown.control.servo.assist;
  assist.gives_way = true;
  const auto beat = [&] { help.show(station_.snapshot()); };
  beat();
  EXPECT_TRUE(help.state().reason.isEmpty());
  EXPECT_EQ(help.state().level, QStringLiteral("100 %"));
  EXPECT_FALSE(help.state().can_raise);
  help.lessen();
  EXPECT_EQ(wanted, (control::Help{false, 0.9}));
  station_.shown.control.help.level = 0.44;  // as a plan may begin
  beat();
  help.lessen();
  EXPECT_EQ(wanted, (control::Help{false, 0.4}));
  station_.shown.control.help.level = 0.44;
  help.raise();
  EXPECT_EQ(wanted, (control::Help{false, 0.5}));
  beat();
  help.setAdapts(true);
  EXPECT_EQ(wanted, (control::Help{true, 0.5}));
  assist.level = 0.27;
  beat();
  EXPECT_TRUE(help.state().adapts);
  EXPECT_FALSE(help.state().can_lessen || help.state().can_raise);
  help.setAdapts(false);
  EXPECT_EQ(wanted, (control::Help{false, 0.3}));
  for (int i = 0; i < 5; ++i) {
    beat();
    help.lessen();
  }
  beat();
  EXPECT_EQ(wanted, (control::Help{false, 0.0}));
  EXPECT_FALSE(help.state().can_lessen);
}

TEST(Summary, TellsForceAndHelpWhereTheyAreKnown) {
  therapy::SessionMeasures measures;
  const auto without = summaryOf(measures).size();
  measures.force_share = 0.43;
  EXPECT_EQ(summaryOf(measures).back().value, QStringLiteral("43 %"));
  measures.help_level = 0.62;
  measures.help_adapting_share = 0.8;
  const auto lines = summaryOf(measures);
  ASSERT_EQ(lines.size(), without + 3);
  EXPECT_EQ(lines[without + 1].value, QStringLiteral("62 %"));
  EXPECT_EQ(lines[without + 2].value, QStringLiteral("80 %"));
}

TEST_F(Presenters, TheChosenMappingGoesWithAligning) {
  station_.enter(Phase::kTaught);
  beat();
  EXPECT_TRUE(session_.state().can_choose_mapping);
  session_.setMapping(therapy::Mapping::kMirror);
  session_.ask(Action::kAlign);
  EXPECT_EQ(station_.last_command.mapping, therapy::Mapping::kMirror);
  beat();
  EXPECT_FALSE(session_.state().can_choose_mapping) << "aligning fixes it";
  EXPECT_EQ(session_.state().mapping, therapy::Mapping::kMirror);
}

TEST_F(Presenters, NothingIsPublishedWhileNothingChanges) {
  beat();
  int published = 0;
  QObject::connect(&session_, &SessionPresenter::stateChanged, [&published] { ++published; });
  for (int i = 0; i < 10; ++i) beat();
  EXPECT_EQ(published, 0);
}

TEST_F(Presenters, TheLightIsGoodOnlyForAFreshTrackedTarget) {
  TrackingPresenter tracking;
  tracking.show(station_.snapshot(), Clock::now());
  EXPECT_EQ(tracking.state().light, Light::kOff);
  station_.enter(Phase::kTaught);
  tracking.show(station_.snapshot(), Clock::now());
  EXPECT_EQ(tracking.state().light, Light::kGood);
  EXPECT_EQ(tracking.state().markers, QStringLiteral("10 / 10"));
  station_.frozen = true;
  tracking.show(station_.snapshot(), Clock::now() + std::chrono::milliseconds(150));
  EXPECT_EQ(tracking.state().light, Light::kBad) << "a pose of yesterday is not green";
  tracking.show(station_.snapshot(), Clock::now() + std::chrono::milliseconds(500));
  EXPECT_FALSE(tracking.state().detail.isEmpty()) << "silent cameras are named";
}

TEST_F(Presenters, JointsStandBetweenTheirLimits) {
  RobotPresenter robot(workplace_);
  robot.show(station_.snapshot(), Clock::now());
  ASSERT_EQ(robot.figures().joints.size(), 7U);
  EXPECT_TRUE(robot.figures().answers);
  EXPECT_NEAR(robot.figures().joints[0].place, 0.5, 1e-6);
  EXPECT_FALSE(robot.figures().joints[0].near_limit);
  station_.shown.control.servo.measured.q_rad[0] = workplace_.limits.upper_rad[0];
  station_.shown.control.servo.commanded.v_rad_s[1] = -workplace_.limits.max_speed_rad_s[1] / 2;
  robot.show(station_.snapshot(), Clock::now() + std::chrono::seconds(1));
  EXPECT_NEAR(robot.figures().joints[0].place, 1.0, 1e-6);
  EXPECT_TRUE(robot.figures().joints[0].near_limit);
  EXPECT_NEAR(robot.figures().joints[1].speed_share, -0.5, 1e-6);
}

// Joint A1 alone turns everything about the base's z axis: the sling's speed is its distance from it times w.
TEST_F(Presenters, TheToolSpeedIsThatOfTheSling) {
  RobotPresenter robot(workplace_);
  station_.shown.control.servo.measured.v_rad_s[0] = 0.2;
  robot.show(station_.snapshot(), Clock::now());
  const Eigen::Vector3d sling_B = (station_.shown.control.X_BF * workplace_.X_FE).translation();
  EXPECT_NEAR(robot.figures().tool_speed_m_s, 0.2 * sling_B.head<2>().norm(), 1e-9);
}

TEST_F(Presenters, ReadinessNamesWhatIsMissing) {
  auto snapshot = station_.snapshot();
  for (const auto& check : readinessOf(snapshot, workplace_, Clock::now()))
    if (!check.text.contains(QStringLiteral("alibrat"))) {
      EXPECT_TRUE(check.passed) << check.text.toStdString();
    }
  const auto empty = readinessOf({}, workplace_, Clock::now());
  EXPECT_FALSE(empty[0].passed);
  EXPECT_FALSE(empty[1].passed);
}

TEST_F(Presenters, TheJournalWritesChangesOnce) {
  LogModel log;
  Journal journal(log);
  journal.show(station_.snapshot());
  EXPECT_EQ(log.rowCount(), 0);
  station_.enter(Phase::kTeaching);
  for (int i = 0; i < 5; ++i) journal.show(station_.snapshot());
  EXPECT_EQ(log.rowCount(), 1);
  station_.stop(control::StopReason::kTargetLost);
  journal.show(station_.snapshot());
  EXPECT_EQ(log.rowCount(), 1) << "a stop is written as the alarm that it is";
  station_.resetStop();
  journal.show(station_.snapshot());
  EXPECT_EQ(log.rowCount(), 2);
}

TEST(Words, EveryReasonHasSome) {
  for (int i = 0; i < control::kStopReasonCount; ++i) {
    EXPECT_FALSE(words(static_cast<control::StopReason>(i)).isEmpty());
    if (i > 0) {
      EXPECT_FALSE(advice(static_cast<control::StopReason>(i)).isEmpty());
    }
  }
  for (int i = 0; i < kActionCount; ++i) EXPECT_FALSE(words(static_cast<Action>(i)).isEmpty());
  for (int i = 0; i <= static_cast<int>(robot::GuardAction::kToolAcceleration); ++i)
    EXPECT_FALSE(words(static_cast<robot::GuardAction>(i)).isEmpty());
  for (int i = 0; i <= static_cast<int>(station::Answer::kQueueFull); ++i)
    EXPECT_FALSE(words(static_cast<station::Answer>(i)).isEmpty());
}

}  // namespace
}  // namespace mirrorarm::ui
