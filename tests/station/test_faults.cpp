#include "bench_session.h"
#include "core/records/store.h"

namespace mirrorarm::station {
namespace {

using control::StopReason;

/// A training session two seconds in, while the robot moves.
class Fault : public ::testing::Test {
 protected:
  Fault() : session_({.training = Seconds(30.0), .max_restarts = 0}) {
    session_.runUntil(isTraining);
    session_.runUntil([](const Snapshot& seen) { return seen.control.session_s > 2.0; });
  }

  /// After a fault: the reason is latched, the robot at rest, what was recorded is on the disc.
  void expectRest(StopReason reason, Seconds within) {
    const auto& seen = session_.wait(within);
    EXPECT_EQ(seen.control.servo.stop, reason) << id(seen.control.servo.stop);
    EXPECT_EQ(seen.control.phase, therapy::Phase::kPaused);
    const auto rest = session_.bench().truthAt(seen.control.time).X_BF;
    const auto& later = session_.wait(Seconds(0.5));
    const auto still = session_.bench().truthAt(later.control.time).X_BF;
    EXPECT_LT((rest.translation() - still.translation()).norm(), 1e-4);
    expectRecord("stop." + std::string(id(reason)));
  }

  void expectRecord(const std::string& event) {
    auto store = records::Store::openExisting(session_.folder() / "store.sqlite");
    ASSERT_TRUE(store) << store.error().reason;
    const auto samples = (*store)->samples(1);
    ASSERT_TRUE(samples);
    EXPECT_GT(samples->size(), 40u);
    const auto events = (*store)->events(1);
    ASSERT_TRUE(events);
    EXPECT_TRUE(
        std::any_of(events->begin(), events->end(), [&](const auto& one) { return one.event == event; }));
  }

  BenchSession session_;
};

TEST_F(Fault, ACameraThatStopsBringsTheRobotToRest) {
  session_.bench().failCameras(true);
  expectRest(StopReason::kCameraSilent, Seconds(1.0));
}

TEST_F(Fault, ATargetThatVanishesBringsTheRobotToRest) {
  session_.bench().hideTarget(true);
  expectRest(StopReason::kTargetLost, Seconds(1.0));
}

TEST_F(Fault, ARobotThatDoesNotAnswerIsHalted) {
  session_.bench().silenceRobot(true);
  expectRest(StopReason::kRobotSilent, Seconds(1.0));
}

TEST_F(Fault, StopIsLatchedUntilItIsResetAndResettingStartsNothing) {
  session_.station().stop(StopReason::kOperator);
  expectRest(StopReason::kOperator, Seconds(1.0));
  ASSERT_EQ(session_.station().request({therapy::Action::kStart}), Answer::kAccepted);
  EXPECT_EQ(session_.wait(Seconds(0.1)).control.last_answer, Answer::kStopLatched);

  session_.station().resetStop();
  const auto before = session_.bench().truthAt(session_.wait(Seconds(0.1)).control.time).X_BF;
  const auto& seen = session_.wait(Seconds(1.0));
  EXPECT_EQ(seen.control.servo.stop, StopReason::kNone);
  EXPECT_LT((before.translation() - session_.bench().truthAt(seen.control.time).X_BF.translation()).norm(),
            1e-4);
}

TEST_F(Fault, EveryStopLeavesABlackBox) {
  session_.station().stop(StopReason::kOperator);
  session_.wait(Seconds(1.0));
  int boxes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(session_.folder()))
    if (entry.path().filename().string().starts_with("stop-")) {
      ++boxes;
      EXPECT_GT(std::filesystem::file_size(entry), 10'000u);
    }
  EXPECT_EQ(boxes, 1);
}

TEST_F(Fault, AShortLossOnlyHolds) {
  session_.bench().hideTarget(true);
  session_.wait(Seconds(0.10));
  session_.bench().hideTarget(false);
  const auto& seen = session_.wait(Seconds(0.5));
  EXPECT_EQ(seen.control.servo.stop, StopReason::kNone);
  EXPECT_EQ(seen.control.phase, therapy::Phase::kTraining);
}

}  // namespace
}  // namespace mirrorarm::station
