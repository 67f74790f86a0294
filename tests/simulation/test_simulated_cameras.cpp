#include <gtest/gtest.h>

#include "core/camera/rig_file.h"
#include "core/simulation/simulated_cameras.h"

namespace mirrorarm::simulation {
namespace {

class SimulatedCamerasTest : public ::testing::Test {
 protected:
  void SetUp() override { time_.set(start_); }
  SimulatedCameras make(bool waits) {
    return {*camera::readRig(std::filesystem::path(RESOURCES) / "rigs/pinhole.yaml"),
            {},
            {},
            {25.0, Seconds(0.0015), Seconds(0.020), waits},
            [this](TimePoint at, StereoRenderer::Instant& patches) {
              asked_.push_back(at);
              patches.clear();
            },
            time_,
            1};
  }
  const TimePoint start_ = fromNanoseconds(2'000'000'000);
  ManualTime time_;
  std::vector<TimePoint> asked_;
};

TEST_F(SimulatedCamerasTest, AFrameIsReadyAfterExposureAndTransfer) {
  auto cameras = make(false);
  EXPECT_EQ(cameras.next(Seconds(1.0)).error(), camera::NoFrame::kTimeout);
  time_.set(start_ + std::chrono::microseconds(21'499));
  EXPECT_EQ(cameras.next(Seconds(1.0)).error(), camera::NoFrame::kTimeout);
  time_.set(start_ + std::chrono::microseconds(21'501));
  const auto frame = cameras.next(Seconds(1.0));
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->sequence, 0u);
  EXPECT_EQ(frame->exposed_at, start_ + std::chrono::microseconds(750));
  EXPECT_EQ(frame->left.width(), 1296);
  EXPECT_EQ(cameras.next(Seconds(0.0)).error(), camera::NoFrame::kTimeout);
}

TEST_F(SimulatedCamerasTest, TheWorldIsSeenDuringTheExposure) {
  auto cameras = make(false);
  time_.set(start_ + std::chrono::milliseconds(30));
  ASSERT_TRUE(cameras.next(Seconds(0.0)));
  ASSERT_EQ(asked_.size(), 3u);
  for (const auto at : asked_) {
    EXPECT_GE(at, start_);
    EXPECT_LE(at, start_ + std::chrono::microseconds(1500));
  }
}

TEST_F(SimulatedCamerasTest, ALateReaderGetsTheNewestFrame) {
  auto cameras = make(false);
  time_.set(start_ + std::chrono::milliseconds(215));
  const auto frame = cameras.next(Seconds(0.0));
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->sequence, 4u);
  time_.set(start_ + std::chrono::milliseconds(222));
  EXPECT_EQ(cameras.next(Seconds(0.0))->sequence, 5u);
}

TEST_F(SimulatedCamerasTest, APulledCableGivesNothingUntilItIsBack) {
  auto cameras = make(false);
  cameras.fail(true);
  time_.set(start_ + std::chrono::milliseconds(100));
  EXPECT_EQ(cameras.next(Seconds(0.0)).error(), camera::NoFrame::kTimeout);
  cameras.fail(false);
  EXPECT_EQ(cameras.next(Seconds(0.0))->sequence, 1u);
}

TEST_F(SimulatedCamerasTest, WaitsWhenItHasItsOwnPace) {
  auto cameras = make(true);
  EXPECT_EQ(cameras.next(Seconds(0.01)).error(), camera::NoFrame::kTimeout);
  time_.set(start_ + std::chrono::milliseconds(50));
  EXPECT_TRUE(cameras.next(Seconds(0.01)));
}

}  // namespace
}  // namespace mirrorarm::simulation
