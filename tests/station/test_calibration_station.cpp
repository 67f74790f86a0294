#include <thread>

#include "core/station/calibration_station.h"
#include "tests/station/bench_calibration.h"

namespace mirrorarm::station {
namespace {

/// The real threads on the wall clock.
class OnItsThreads : public ::testing::Test {
 protected:
  OnItsThreads() {
    auto settings = benchWithPlate();
    settings.own_pace = true;
    settings.rate_hz = 10.0;
    bench_ = *simulation::Bench::make(settings, time_);
    CalibrationSettings calibration;
    calibration.folder = folder_.path();
    calibration.supervisor.camera_silent_after = Seconds(2.0);  // other tests may run beside
    calibration.supervisor.servo_late_after = Seconds(2.0);
    calibration.supervisor.planner_silent_after = Seconds(2.0);
    station_ = std::make_unique<CalibrationStation>(equipmentOf(*bench_), calibration);
  }

  template <class Done>
  bool waitFor(Done done) {
    for (int i = 0; i < 1000; ++i) {
      seen_ = station_->snapshot();
      if (done(seen_)) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    return false;
  }

  bool beginAndTakeOne() {
    return station_->request({.action = CalibrationAction::kBegin, .board = kPlate}) ==
               CalibrationAnswer::kAccepted &&
           waitFor([](const auto& seen) { return seen.views && seen.views->size() == 1; });
  }

  const SteadyTime time_;
  test::ScratchFolder folder_;
  std::unique_ptr<simulation::Bench> bench_;
  std::unique_ptr<CalibrationStation> station_;
  CalibrationSnapshot seen_;
};

TEST_F(OnItsThreads, AViewIsTakenAndAProposalMadeAndSolvingRefused) {
  ASSERT_TRUE(beginAndTakeOne());
  EXPECT_TRUE(seen_.views->front().X_BF);
  EXPECT_TRUE(waitFor([](const auto& seen) { return seen.proposal.has_value(); }));
  ASSERT_EQ(station_->request({.action = CalibrationAction::kSolve}), CalibrationAnswer::kAccepted);
  EXPECT_TRUE(waitFor([](const auto& seen) { return seen.phase == CalibrationPhase::kRefused; }));
}

TEST_F(OnItsThreads, StopsFromAnyThreadWhileItDrives) {
  ASSERT_TRUE(beginAndTakeOne());
  ASSERT_EQ(station_->request({.action = CalibrationAction::kSetDriving, .on = true}),
            CalibrationAnswer::kAccepted);
  ASSERT_TRUE(waitFor([](const auto& seen) { return seen.driving && !seen.servo.at_rest; }));
  std::jthread somebody([this] { station_->stop(control::StopReason::kOperator); });
  somebody.join();
  EXPECT_TRUE(waitFor([](const auto& seen) {
    return seen.servo.stop == control::StopReason::kOperator && seen.servo.at_rest && !seen.driving;
  }));
}

TEST_F(OnItsThreads, EndsWhileItSolvesAndLeavesNothing) {
  ASSERT_TRUE(beginAndTakeOne());
  ASSERT_EQ(station_->request({.action = CalibrationAction::kSolve}), CalibrationAnswer::kAccepted);
  station_.reset();
  EXPECT_TRUE(!std::filesystem::exists(folder_ / "work") || std::filesystem::is_empty(folder_ / "work"));
}

}  // namespace
}  // namespace mirrorarm::station
