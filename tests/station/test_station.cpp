#include <thread>

#include "bench_session.h"
#include "core/station/station.h"

namespace mirrorarm::station {
namespace {

/// Cameras that fail in a way that nobody foresaw.
class BrokenCameras final : public camera::FrameSource {
 public:
  Expected<camera::StereoFrame, camera::NoFrame> next(Seconds) override {
    throw std::runtime_error("the driver fell over");
  }
  double rate_hz() const override { return 24.0; }
};

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

TEST(Station, AnExceptionOfTheCamerasStopsTheRobot) {
  const SteadyTime time;
  auto bench = simulation::Bench::make(benchFor("reach", true), time);
  ASSERT_TRUE(bench) << describe(bench.error());
  BrokenCameras cameras;
  auto equipment = equipmentOf(**bench);
  equipment.cameras = &cameras;
  Station station(equipment, {});
  auto stop = control::StopReason::kNone;
  for (int i = 0; i < 500 && stop == control::StopReason::kNone; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    stop = station.snapshot().control.servo.stop;
  }
  EXPECT_EQ(stop, control::StopReason::kInternal);
}

}  // namespace
}  // namespace mirrorarm::station
