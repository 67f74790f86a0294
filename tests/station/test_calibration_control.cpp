#include <algorithm>

#include "core/station/calibration_stages.h"
#include "tests/station/bench_calibration.h"

namespace mirrorarm::station {
namespace {

using Action = CalibrationAction;
using Answer = CalibrationAnswer;
using Job = CalibrationJob;
using Phase = CalibrationPhase;

bool isUnderWay(const CalibrationSnapshot& seen) { return !seen.servo.at_rest; }

std::size_t filesIn(const std::filesystem::path& folder) {
  if (!std::filesystem::exists(folder)) return 0;
  const auto all = std::filesystem::recursive_directory_iterator(folder);
  return static_cast<std::size_t>(
      std::count_if(begin(all), end(all), [](const auto& entry) { return entry.is_regular_file(); }));
}

TEST(CalibrationControl, RefusesWhatThePhaseDoesNotAllow) {
  BenchCalibration bench;
  for (const auto action : {Action::kCapture, Action::kSetDriving, Action::kRemoveView, Action::kUndoRemove,
                            Action::kSolve, Action::kAccept, Action::kDiscard})
    EXPECT_EQ(bench.ask({.action = action, .on = true}), Answer::kNotNow);
  EXPECT_EQ(bench.ask({.action = Action::kBegin}), Answer::kNoBoard);
  for (const auto job : {Job::kHandEye, Job::kClock, Job::kDrift})
    EXPECT_EQ(bench.ask({.action = Action::kBegin, .job = job, .board = kPlate}), Answer::kNoCalibration);
  EXPECT_EQ(bench.seen().phase, Phase::kIdle);
}

TEST(CalibrationControl, TooFewViewsAreRefusedWithTheRemedyAndCapturingGoesOn) {
  BenchCalibration bench;
  ASSERT_EQ(bench.begin(Job::kStereo), Answer::kAccepted);
  ASSERT_EQ(bench.seen().views->size(), 1u);
  EXPECT_FALSE(bench.solve());
  EXPECT_EQ(bench.seen().phase, Phase::kRefused);
  EXPECT_FALSE(bench.seen().refusal.empty());
  EXPECT_EQ(bench.ask({.action = Action::kDiscard}), Answer::kAccepted);
  EXPECT_EQ(bench.seen().phase, Phase::kCapturing);
  EXPECT_EQ(bench.seen().views->size(), 1u);
}

TEST(CalibrationControl, WithoutARobotTheBoardIsHeldInTheHand) {
  BenchCalibration bench(
      {.change = [](Equipment& equipment) { equipment.robot = nullptr; }, .before = truthInForce});
  EXPECT_EQ(bench.begin(Job::kHandEye), Answer::kNoRobot);
  ASSERT_EQ(bench.begin(Job::kStereo), Answer::kAccepted);
  EXPECT_EQ(bench.seen().views->size(), 1u);
  EXPECT_FALSE(bench.seen().views->front().X_BF);
  EXPECT_TRUE(bench.seen().proposal);
  EXPECT_EQ(bench.drive(), Answer::kNoRobot);
}

TEST(CalibrationControl, AViewIsTakenWhenAskedForAndRemovedAndBroughtBack) {
  BenchCalibration bench;
  ASSERT_EQ(bench.begin(Job::kStereo), Answer::kAccepted);
  ASSERT_EQ(bench.setAutomatic(false), Answer::kAccepted);
  ASSERT_EQ(bench.ask({.action = Action::kCapture}), Answer::kAccepted);
  ASSERT_EQ(bench.seen().views->size(), 2u);
  EXPECT_EQ(bench.ask({.action = Action::kRemoveView, .view = 7}), Answer::kNotNow);
  ASSERT_EQ(bench.ask({.action = Action::kRemoveView, .view = 0}), Answer::kAccepted);
  ASSERT_EQ(bench.seen().views->size(), 1u);
  EXPECT_EQ(bench.seen().views->front().name, "02");
  ASSERT_TRUE(bench.seen().can_undo);
  ASSERT_EQ(bench.ask({.action = Action::kUndoRemove}), Answer::kAccepted);
  ASSERT_EQ(bench.seen().views->size(), 2u);
  EXPECT_EQ(bench.seen().views->front().name, "01");
  EXPECT_FALSE(bench.seen().can_undo);
}

TEST(CalibrationControl, WithoutABoardInViewNothingIsTaken) {
  BenchCalibration bench;
  bench.bench().hideTarget(true);
  ASSERT_EQ(bench.begin(Job::kStereo), Answer::kAccepted);
  EXPECT_EQ(bench.seen().views->size(), 0u);
  EXPECT_EQ(bench.ask({.action = Action::kCapture}), Answer::kNoBoard);
  EXPECT_EQ(bench.drive(), Answer::kNoBoard);
}

TEST(CalibrationControl, WhatIsCancelledLeavesNothing) {
  BenchCalibration bench({.before = truthInForce});
  const auto before = filesIn(bench.folder().path());
  ASSERT_EQ(bench.begin(Job::kDrift), Answer::kAccepted);
  EXPECT_EQ(filesIn(bench.folder().path()), before + 2);  // both images of the view
  ASSERT_TRUE(bench.solve());
  ASSERT_EQ(bench.ask({.action = Action::kCancel}), Answer::kAccepted);
  EXPECT_EQ(bench.seen().phase, Phase::kIdle);
  EXPECT_EQ(bench.ask({.action = Action::kAccept}), Answer::kNotNow);
  EXPECT_EQ(filesIn(bench.folder().path()), before);
  EXPECT_FALSE(bench.inForce().drift);
}

TEST(CalibrationControl, AClosedWindowLeavesNothing) {
  BenchCalibration bench({.before = truthInForce});
  const auto before = filesIn(bench.folder().path());
  ASSERT_EQ(bench.begin(Job::kDrift), Answer::kAccepted);
  ASSERT_TRUE(bench.solve());
  bench.end();
  EXPECT_EQ(filesIn(bench.folder().path()), before);
}

TEST(CalibrationControl, ImagesOfRemovedViewsDoNotBelongToTheRecord) {
  BenchCalibration bench({.before = truthInForce});
  ASSERT_EQ(bench.begin(Job::kDrift), Answer::kAccepted);
  ASSERT_EQ(bench.ask({.action = Action::kCapture}), Answer::kAccepted);
  ASSERT_EQ(bench.setAutomatic(false), Answer::kAccepted);
  ASSERT_EQ(bench.ask({.action = Action::kRemoveView, .view = 0}), Answer::kAccepted);
  ASSERT_TRUE(bench.solve());
  ASSERT_EQ(bench.ask({.action = Action::kAccept}), Answer::kAccepted);
  const auto record = bench.folder().path() / "records" / bench.seen().record;
  EXPECT_FALSE(std::filesystem::exists(record / "left_01.png"));
  EXPECT_TRUE(std::filesystem::exists(record / "left_02.png"));
}

TEST(CalibrationControl, ARecordThatCannotBeWrittenIsSaidAndNothingIsLost) {
  BenchCalibration bench({.before = truthInForce});
  ASSERT_EQ(bench.begin(Job::kDrift), Answer::kAccepted);
  ASSERT_TRUE(bench.solve());
  std::filesystem::remove(bench.folder().path() / "in_force.yaml");
  std::filesystem::create_directory(bench.folder().path() / "in_force.yaml");
  EXPECT_EQ(bench.ask({.action = Action::kAccept}), Answer::kNotWritten);
  EXPECT_EQ(bench.seen().phase, Phase::kSolved);
  EXPECT_TRUE(bench.seen().outcome);
}

TEST(CalibrationControl, StopBringsTheRobotToRestAndLatches) {
  BenchCalibration bench;
  ASSERT_EQ(bench.begin(Job::kStereo), Answer::kAccepted);
  ASSERT_EQ(bench.drive(), Answer::kAccepted);
  ASSERT_TRUE(bench.waitFor(isUnderWay, Seconds(3.0)));
  bench.wait(Seconds(0.3));
  bench.station().stop(control::StopReason::kOperator);
  EXPECT_FALSE(bench.wait(Seconds(1.0)).driving);
  EXPECT_TRUE(bench.seen().servo.at_rest);
  EXPECT_EQ(bench.seen().servo.stop, control::StopReason::kOperator);
  EXPECT_EQ(bench.drive(), Answer::kStopLatched);
  const robot::Joints q = bench.seen().servo.commanded.q_rad;
  bench.station().resetStop();
  EXPECT_LT((bench.wait(Seconds(1.0)).servo.commanded.q_rad - q).norm(), 1e-6);  // a reset starts nothing
  EXPECT_EQ(bench.drive(), Answer::kAccepted);
  EXPECT_TRUE(bench.waitFor(isUnderWay, Seconds(3.0)));
}

/// The engineer keeps the device where it is until `done`, or for so long.
bool hold(BenchCalibration& bench, control::EnablingPosition position, Seconds most,
          const std::function<bool(const CalibrationSnapshot&)>& done) {
  return bench.waitFor(
      [&](const CalibrationSnapshot& seen) {
        bench.station().setEnabling(position);
        return done(seen);
      },
      most);
}

TEST(CalibrationControl, DrivingNeedsTheEnablingDeviceAllTheTime) {
  using control::EnablingPosition;
  const auto never = [](const CalibrationSnapshot&) { return false; };
  BenchCalibration bench({.settings = {.supervisor = {.enabling_needed = true}}});
  ASSERT_EQ(bench.begin(Job::kStereo), Answer::kAccepted);
  EXPECT_EQ(bench.drive(), Answer::kNotEnabled);
  hold(bench, EnablingPosition::kEnabled, Seconds(0.2), never);
  ASSERT_EQ(bench.drive(), Answer::kAccepted);
  ASSERT_TRUE(hold(bench, EnablingPosition::kEnabled, Seconds(3.0), isUnderWay));
  hold(bench, EnablingPosition::kReleased, Seconds(1.0), never);
  EXPECT_EQ(bench.seen().servo.stop, control::StopReason::kEnablingReleased);
  EXPECT_TRUE(bench.seen().servo.at_rest);
  EXPECT_FALSE(bench.seen().driving);

  bench.station().resetStop();
  hold(bench, EnablingPosition::kEnabled, Seconds(0.2), never);
  ASSERT_EQ(bench.drive(), Answer::kAccepted);
  const auto waits = [](const CalibrationSnapshot& seen) { return seen.driving && seen.servo.at_rest; };
  ASSERT_TRUE(hold(bench, EnablingPosition::kEnabled, Seconds(3.0), isUnderWay));
  ASSERT_TRUE(hold(bench, EnablingPosition::kEnabled, Seconds(60.0), waits));
  hold(bench, EnablingPosition::kPressedThrough, Seconds(0.3), never);
  EXPECT_EQ(bench.seen().servo.stop, control::StopReason::kEnablingPressedThrough) << "at rest at a view";
  EXPECT_FALSE(bench.seen().driving);
}

TEST(CalibrationControl, DrivingThatIsSwitchedOffEndsAtRest) {
  BenchCalibration bench;
  ASSERT_EQ(bench.begin(Job::kStereo), Answer::kAccepted);
  ASSERT_EQ(bench.drive(), Answer::kAccepted);
  ASSERT_TRUE(bench.waitFor(isUnderWay, Seconds(3.0)));
  ASSERT_EQ(bench.drive(false), Answer::kAccepted);
  EXPECT_TRUE(bench.wait(Seconds(1.0)).servo.at_rest);
  EXPECT_EQ(bench.seen().servo.stop, control::StopReason::kNone);
  EXPECT_FALSE(bench.seen().driving);
}

TEST(CalibrationControl, SilentCamerasStopTheDriving) {
  BenchCalibration bench;
  ASSERT_EQ(bench.begin(Job::kStereo), Answer::kAccepted);
  ASSERT_EQ(bench.drive(), Answer::kAccepted);
  ASSERT_TRUE(bench.waitFor(isUnderWay, Seconds(3.0)));
  bench.bench().failCameras(true);
  bench.wait(Seconds(2.0));
  EXPECT_EQ(bench.seen().servo.stop, control::StopReason::kCameraSilent);
  EXPECT_TRUE(bench.seen().servo.at_rest);
  EXPECT_FALSE(bench.seen().driving);
}

TEST(CalibrationControl, DeadCamerasHoldTheStopAndTakeTheDrivesAway) {
  BenchCalibration bench;
  ASSERT_EQ(bench.begin(Job::kStereo), Answer::kAccepted);
  ASSERT_EQ(bench.drive(), Answer::kAccepted);
  ASSERT_TRUE(bench.waitFor(isUnderWay, Seconds(3.0)));
  bench.bench().failCameras(true);
  bench.wait(Seconds(2.0));
  EXPECT_EQ(bench.seen().servo.category, control::StopCategory::kOne);
  bench.station().resetStop();
  EXPECT_EQ(bench.wait(Seconds(0.1)).servo.stop, control::StopReason::kCameraSilent);
  bench.bench().failCameras(false);
  bench.wait(Seconds(1.0));
  bench.station().resetStop();
  EXPECT_EQ(bench.wait(Seconds(0.1)).servo.stop, control::StopReason::kNone);
}

TEST(CalibrationControl, AControlThreadThatHangsStopsTheDriving) {
  ManualTime time;
  time.set(TimePoint(std::chrono::seconds(1)));
  const auto bench = simulation::Bench::make(benchWithPlate(), time);
  ASSERT_TRUE(bench);
  CalibrationSettings settings;
  settings.supervisor.camera_silent_after = Seconds(0.6);
  JobsAtOnce jobs;
  const auto equipment = equipmentOf(**bench);
  CalibrationStages stages(equipment, settings, jobs);
  control::ServoState servo;
  bool control_lives = true;
  const auto runUntil = [&](const std::function<bool()>& done) {
    for (int cycle = 0; cycle < 60'000; ++cycle) {
      if (done()) return cycle;
      time.set(time.now() + std::chrono::milliseconds(1));
      servo = stages.servo->step(time.now());
      if (const auto frame = equipment.cameras->next(Seconds(0.0))) {
        stages.control.frameCame(frame->exposed_at);
        stages.control.report(stages.boards.process(*frame));
      }
      if (control_lives && cycle % 10 == 0) stages.control.step(time.now());
    }
    return -1;
  };
  const auto isMoving = [&] {
    return servo.commanded.v_rad_s.size() > 0 && servo.commanded.v_rad_s.norm() > 0.1;
  };
  const auto asked =
      stages.control.request({.action = CalibrationAction::kBegin, .job = Job::kStereo, .board = kPlate});
  ASSERT_EQ(asked, Answer::kAccepted);
  const auto seen = [&] { return stages.snapshot().views && !stages.snapshot().views->empty(); };
  ASSERT_GE(runUntil(seen), 0);
  static_cast<void>(stages.control.request({.action = CalibrationAction::kSetDriving, .on = true}));
  ASSERT_GE(runUntil(isMoving), 0);
  control_lives = false;
  const int cycles = runUntil([&] { return servo.stop != control::StopReason::kNone; });
  EXPECT_EQ(servo.stop, control::StopReason::kPlannerSilent);
  EXPECT_LE(cycles, 152);
  EXPECT_LE(runUntil([&] { return servo.at_rest; }), 500);
}

TEST(CalibrationControl, AStopJustBeforeItIsLeftLeavesItsBlackBox) {
  BenchCalibration bench;
  ASSERT_EQ(bench.begin(Job::kStereo), Answer::kAccepted);
  ASSERT_EQ(bench.drive(), Answer::kAccepted);
  ASSERT_TRUE(bench.waitFor(isUnderWay, Seconds(3.0)));
  bench.station().stop(control::StopReason::kOperator);
  bench.wait(Seconds(0.02));
  bench.end();
  const auto boxes = std::ranges::count_if(
      std::filesystem::directory_iterator(bench.scratch()),
      [](const auto& file) { return file.path().filename().string().starts_with("stop-"); });
  EXPECT_EQ(boxes, 1);
}

TEST(CalibrationControl, ASilentRobotEndsTheDriving) {
  BenchCalibration bench;
  ASSERT_EQ(bench.begin(Job::kStereo), Answer::kAccepted);
  ASSERT_EQ(bench.drive(), Answer::kAccepted);
  ASSERT_TRUE(bench.waitFor(isUnderWay, Seconds(3.0)));
  bench.bench().silenceRobot(true);
  bench.wait(Seconds(1.0));
  EXPECT_EQ(bench.seen().servo.stop, control::StopReason::kRobotSilent);
  EXPECT_FALSE(bench.seen().driving);
}

}  // namespace
}  // namespace mirrorarm::station
