#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "bench_session.h"
#include "core/records/store.h"

namespace mirrorarm::station {
namespace {

using control::EnablingPosition;
using control::ResetRefusal;
using control::StopReason;

constexpr ScriptSettings kLong{.training = Seconds(60.0), .max_restarts = 0};

std::size_t boxesIn(const std::filesystem::path& folder) {
  return static_cast<std::size_t>(
      std::count_if(std::filesystem::directory_iterator(folder), {},
                    [](const auto& entry) { return entry.path().filename().string().starts_with("stop-"); }));
}

StationSettings withEnabling() {
  StationSettings settings;
  settings.supervisor.enabling_needed = true;
  return settings;
}

/// Runs a session into its second second of training.
void train(BenchSession& session, double seconds = 2.0) {
  ASSERT_EQ(session.runUntil(
                [&](const Snapshot& seen) { return isTraining(seen) && seen.control.session_s > seconds; }),
            SessionScript::Progress::kRunning)
      << session.script().failure();
}

/// What the session's record says of the help, in the order of its events.
std::vector<std::string> helpEventsOf(BenchSession& session) {
  const auto store = records::Store::openExisting(session.folder() / "store.sqlite").value();
  std::vector<std::string> found;
  const auto events = store->events(1).value();
  for (const auto& event : events)
    if (event.event.starts_with("help.")) found.push_back(event.event);
  return found;
}

/// The operator keeps the device where it is for so long.
const Snapshot& hold(BenchSession& session, EnablingPosition position, double seconds) {
  const Snapshot* seen = nullptr;
  for (double t = 0.0; t < seconds; t += 0.05) {
    session.station().setEnabling(position);
    seen = &session.wait(Seconds(0.05));
  }
  return *seen;
}

}  // namespace

TEST(Stops, AreResetOnlyAtRestAndWhenTheCauseIsGone) {
  BenchSession session(kLong);
  train(session);
  session.bench().failCameras(true);
  const auto& stopped = session.wait(Seconds(0.8));
  EXPECT_EQ(stopped.control.servo.stop, StopReason::kCameraSilent);
  EXPECT_EQ(stopped.control.servo.reset, ResetRefusal::kCausePersists);
  EXPECT_EQ(stopped.control.servo.lasting, StopReason::kCameraSilent);
  EXPECT_EQ(stopped.control.servo.category, control::StopCategory::kTwo);
  session.station().resetStop();
  const auto& later = session.wait(Seconds(0.5));
  EXPECT_EQ(later.control.servo.stop, StopReason::kCameraSilent);
  EXPECT_EQ(later.control.servo.category, control::StopCategory::kOne) << "silent for more than a second";
  session.bench().failCameras(false);
  EXPECT_EQ(session.wait(Seconds(0.3)).control.servo.reset, ResetRefusal::kNone);
  session.station().resetStop();
  EXPECT_EQ(session.wait(Seconds(0.3)).control.servo.stop, StopReason::kNone);
  EXPECT_EQ(boxesIn(session.folder()), 1U) << "a hold that became a stop is a stop";
}

TEST(Stops, EachLeavesItsBlackBoxAlsoWithoutAStore) {
  StationSettings settings;
  BenchSession session(kLong, benchFor("reach"), settings);
  session.wait(Seconds(0.5));  // no session, so no record either
  for (int i = 0; i < 2; ++i) {
    session.station().stop(StopReason::kOperator);
    session.wait(Seconds(0.2));
    session.station().resetStop();
    session.wait(Seconds(0.2));
  }
  session.wait(Seconds(0.3));
  EXPECT_EQ(boxesIn(session.folder()), 2U);
}

TEST(Enabling, IsNeededToStartAndWhileTheRobotFollows) {
  BenchSession session(kLong, benchFor("reach"), withEnabling());
  session.runUntil([](const Snapshot& seen) { return seen.control.phase == therapy::Phase::kAligned; });
  hold(session, EnablingPosition::kReleased, 0.2);
  ASSERT_EQ(session.station().request({therapy::Action::kStart}), Answer::kAccepted);
  EXPECT_EQ(hold(session, EnablingPosition::kReleased, 0.2).control.last_answer, Answer::kNotEnabled);

  hold(session, EnablingPosition::kEnabled, 0.2);
  ASSERT_EQ(session.station().request({therapy::Action::kStart}), Answer::kAccepted);
  EXPECT_TRUE(isTraining(hold(session, EnablingPosition::kEnabled, 1.0)));

  const auto& fright = hold(session, EnablingPosition::kPressedThrough, 1.0);
  EXPECT_EQ(fright.control.servo.stop, StopReason::kEnablingPressedThrough);
  EXPECT_EQ(fright.control.servo.reset, ResetRefusal::kCausePersists);
  EXPECT_EQ(fright.control.phase, therapy::Phase::kPaused);
  EXPECT_EQ(hold(session, EnablingPosition::kReleased, 0.1).control.servo.reset, ResetRefusal::kNone);
}

TEST(Enabling, SilenceOfTheDeviceStops) {
  BenchSession session(kLong, benchFor("reach"), withEnabling());
  session.runUntil([](const Snapshot& seen) { return seen.control.phase == therapy::Phase::kAligned; });
  hold(session, EnablingPosition::kEnabled, 0.2);
  ASSERT_EQ(session.station().request({therapy::Action::kStart}), Answer::kAccepted);
  ASSERT_TRUE(isTraining(hold(session, EnablingPosition::kEnabled, 0.5)));
  EXPECT_EQ(session.wait(Seconds(0.4)).control.servo.stop, StopReason::kEnablingReleased);
}

TEST(Force, OfTheHangingArmIsShownAndTooMuchStops) {
  BenchSession session(kLong);
  train(session);
  const auto& calm = session.wait(Seconds(0.5)).control.servo.assist.force;
  ASSERT_TRUE(calm.known);
  EXPECT_NEAR(calm.force_B_n.z(), -15.0, 5.0);
  EXPECT_EQ(calm.level, control::ForceLevel::kCalm);
  session.bench().pushSling({0.0, 60.0, 0.0});
  EXPECT_GE(session.wait(Seconds(1.0)).control.servo.assist.force.level, control::ForceLevel::kWarning);
  session.bench().pushSling({0.0, 120.0, 0.0});
  const auto& stopped = session.wait(Seconds(1.0));
  EXPECT_EQ(stopped.control.servo.stop, StopReason::kForce);
  EXPECT_EQ(stopped.control.servo.reset, ResetRefusal::kCausePersists);
  session.bench().pushSling(Eigen::Vector3d::Zero());
  EXPECT_EQ(session.wait(Seconds(2.0)).control.servo.reset, ResetRefusal::kNone);
}

TEST(Help, FallsWhenThePatientCarriesHisArmAndComesBackWhenHeRelaxes) {
  auto bench = benchFor("reach");
  bench.robot_gives_way = true;
  StationSettings settings;
  settings.assist.help.adapts = true;
  BenchSession session(kLong, bench, settings);
  session.bench().setPatientEffort(1.0);
  train(session, 12.0);
  const auto& able = session.script().seen().control.servo;
  EXPECT_EQ(able.stop, StopReason::kNone);
  const double help_for_the_able = able.assist.level;
  session.bench().setPatientEffort(0.0);
  train(session, 24.0);
  const double help_for_the_relaxed = session.script().seen().control.servo.assist.level;
  EXPECT_GT(help_for_the_relaxed, help_for_the_able + 0.05);
  EXPECT_LE(help_for_the_relaxed, 1.0);
}

TEST(Help, ChangedInASessionGoesThereSteadilyAndIsRecorded) {
  auto bench = benchFor("reach");
  bench.robot_gives_way = true;
  BenchSession session(kLong, bench);
  train(session);
  EXPECT_EQ(session.script().seen().control.help, control::Help{});
  ASSERT_EQ(session.station().changeHelp({false, 0.4}), Answer::kAccepted);
  auto before = session.script().seen().control.servo;
  for (int i = 0; i < 40; ++i) {
    const auto now = session.wait(Seconds(0.05)).control.servo;
    EXPECT_LE(std::abs(now.assist.level - before.assist.level),
              control::AssistPlan{}.max_rate_1_s * secondsBetween(before.time, now.time) + 1e-9);
    before = now;
  }
  EXPECT_DOUBLE_EQ(before.assist.level, 0.4);
  EXPECT_EQ(session.station().changeHelp({true, 0.4}), Answer::kAccepted);
  const auto& adapting = session.wait(Seconds(0.3)).control;
  EXPECT_EQ(adapting.last_answer, Answer::kAccepted);
  EXPECT_EQ(adapting.help, (control::Help{true, 0.4}));
  EXPECT_EQ(adapting.phase, therapy::Phase::kTraining);
  ASSERT_EQ(session.station().request({therapy::Action::kFinish}), Answer::kAccepted);
  const auto& measures = session.wait(Seconds(1.0)).record.measures;
  EXPECT_GT(measures.force_share.value(), 0.05);
  EXPECT_LT(measures.force_share.value(), 0.6);
  EXPECT_GT(measures.help_level.value(), 0.4);
  EXPECT_LT(measures.help_level.value(), 0.9);
  EXPECT_NEAR(measures.help_adapting_share.value(), 0.3 / 4.3, 0.03);
  EXPECT_EQ(helpEventsOf(session),
            (std::vector<std::string>{"help.fixed.100", "help.fixed.40", "help.adapts"}));
}

TEST(Help, CannotBeChangedWhereTheRobotHoldsItsPositionOrBeyondItsRange) {
  BenchSession stiff(kLong);
  stiff.wait(Seconds(0.2));
  ASSERT_EQ(stiff.station().changeHelp({false, 0.4}), Answer::kAccepted);
  const auto& refused = stiff.wait(Seconds(0.2)).control;
  EXPECT_EQ(refused.last_answer, Answer::kHoldsStiffly);
  EXPECT_EQ(refused.help, control::Help{});

  auto bench = benchFor("reach");
  bench.robot_gives_way = true;
  BenchSession soft(kLong, bench);
  soft.wait(Seconds(0.2));
  for (const double level : {-0.1, 1.1, std::nan("")}) {
    ASSERT_EQ(soft.station().changeHelp({false, level}), Answer::kAccepted);
    EXPECT_EQ(soft.wait(Seconds(0.2)).control.last_answer, Answer::kOutOfRange);
  }
  EXPECT_EQ(soft.wait(Seconds(0.2)).control.help, control::Help{});
}

TEST(Line, ThatLosesAMessageInTwentyIsBridged) {
  BenchSession session(kLong);
  train(session);
  session.bench().disturbRobotLine({.lost_share = 0.05, .late_share = 0.05});
  train(session, 5.0);
  EXPECT_EQ(session.script().seen().control.servo.stop, StopReason::kNone);
  session.bench().disturbRobotLine({.lost_share = 1.0});
  EXPECT_EQ(session.wait(Seconds(0.5)).control.servo.stop, StopReason::kRobotSilent);
}

}  // namespace mirrorarm::station
