#include "bench_session.h"

namespace mirrorarm::station {
namespace {

TEST(LockstepSession, FollowsTheArmWithinTheLimitsAndRecordsIt) {
  BenchSession session({.training = Seconds(12.0)});
  ASSERT_EQ(session.run(), SessionScript::Progress::kDone) << session.script().failure();

  const auto& record = session.script().seen().record;
  EXPECT_EQ(record.recording, Recording::kComplete);
  EXPECT_EQ(session.script().stops(), 0);
  EXPECT_EQ(record.lost_samples, 0u);
  EXPECT_GT(record.measures.frames, 280);
  EXPECT_GT(record.measures.tracked_share, 0.99);
  EXPECT_GT(record.measures.range_mm, 50.0);
  EXPECT_GT(record.measures.gain, 0.7);
  EXPECT_GT(record.measures.lag_ms, 50.0);  // camera, transfer and a quintic take their time
  EXPECT_LT(record.measures.lag_ms, 700.0);
  EXPECT_LE(record.measures.joint_speed_ratio, 1.0 + 1e-9);
  EXPECT_LE(record.measures.joint_acceleration_ratio, 1.0 + 1e-9);
}

TEST(LockstepSession, IsTheSameForTheSameSeed) {
  const auto lagOf = [] {
    BenchSession session({.training = Seconds(4.0)});
    EXPECT_EQ(session.run(), SessionScript::Progress::kDone);
    return session.script().seen().record.measures.lag_ms;
  };
  EXPECT_DOUBLE_EQ(lagOf(), lagOf());
}

TEST(LockstepSession, MirrorsTheMovementInTheMidplane) {
  BenchSession session({.training = Seconds(8.0), .mapping = therapy::Mapping::kMirror}, benchFor("side"));
  ASSERT_EQ(session.run(), SessionScript::Progress::kDone) << session.script().failure();
  EXPECT_GT(session.script().seen().record.measures.tracked_share, 0.95);
}

TEST(LockstepSession, CarriesARecordedArm) {
  const std::filesystem::path trc = std::filesystem::path(SHARED_DATA) / "pyomeca-upper-limb/markers.trc";
  if (!std::filesystem::exists(trc)) GTEST_SKIP() << trc << " is absent";
  auto bench = benchFor("reach");
  bench.motion = trc;
  BenchSession session({.training = Seconds(10.0)}, bench);
  ASSERT_EQ(session.run(), SessionScript::Progress::kDone) << session.script().failure();
  EXPECT_GE(session.script().seen().record.measures.tracked_share, 0.95);
}

TEST(LockstepSession, ALessonEndsByItselfOnceItIsPrecise) {
  BenchSession session({.teaching = Seconds(60.0), .training = Seconds(3.0)});
  const auto isTaught = [](const Snapshot& seen) { return seen.control.phase == therapy::Phase::kTaught; };
  ASSERT_EQ(session.runUntil(isTaught), SessionScript::Progress::kRunning) << session.script().failure();
  EXPECT_LT(session.script().seen().control.time, TimePoint(std::chrono::seconds(30)));
  EXPECT_EQ(session.run(), SessionScript::Progress::kDone) << session.script().failure();
}

TEST(LockstepSession, RefusesWhatThePhaseDoesNotAllow) {
  BenchSession session({});
  session.wait(Seconds(0.2));
  ASSERT_EQ(session.station().request({therapy::Action::kStart}), Answer::kAccepted);
  const auto& seen = session.wait(Seconds(0.1));
  EXPECT_EQ(seen.control.last_answer, Answer::kNotNow);
  EXPECT_EQ(seen.control.phase, therapy::Phase::kPrepare);
}

TEST(LockstepSession, TeachingWithoutMarkersSaysSo) {
  BenchSession session({});
  session.bench().hideTarget(true);
  session.wait(Seconds(0.2));
  ASSERT_EQ(session.station().request({therapy::Action::kTeach}), Answer::kAccepted);
  session.wait(Seconds(0.5));
  ASSERT_EQ(session.station().request({therapy::Action::kFinishTeaching}), Answer::kAccepted);
  const auto& seen = session.wait(Seconds(0.3));
  EXPECT_EQ(seen.control.last_answer, Answer::kTooFewMarkers);
  EXPECT_EQ(seen.control.phase, therapy::Phase::kPrepare);
}

}  // namespace
}  // namespace mirrorarm::station
