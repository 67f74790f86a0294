#include <thread>

#include "bench_session.h"
#include "core/station/station.h"

namespace mirrorarm::station {
namespace {

/// The real threads on the wall clock, for a short session.
TEST(Station, RunsASessionOnItsThreads) {
  const SteadyTime time;
  auto bench = simulation::Bench::make(benchFor("reach", true), time);
  ASSERT_TRUE(bench) << describe(bench.error());
  const test::ScratchFolder folder;
  StationSettings settings;
  settings.store_file = folder / "store.sqlite";
  Station station(equipmentOf(**bench), settings);
  SessionScript script(station, {.teaching = Seconds(1.0), .training = Seconds(3.0)},
                       [&](bool moving) { (*bench)->setPatientMoving(moving); });
  auto progress = SessionScript::Progress::kRunning;
  while (progress == SessionScript::Progress::kRunning) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    progress = script.step(Clock::now());
  }
  ASSERT_EQ(progress, SessionScript::Progress::kDone) << script.failure();
  EXPECT_EQ(script.seen().record.recording, Recording::kComplete);
  EXPECT_GT(script.seen().record.measures.frames, 30);
}

TEST(Station, StopsFromAnyThread) {
  const SteadyTime time;
  auto bench = simulation::Bench::make(benchFor("reach", true), time);
  ASSERT_TRUE(bench) << describe(bench.error());
  Station station(equipmentOf(**bench), {});
  std::jthread somebody([&] { station.stop(control::StopReason::kOperator); });
  somebody.join();
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  EXPECT_EQ(station.snapshot().control.servo.stop, control::StopReason::kOperator);
}

}  // namespace
}  // namespace mirrorarm::station
