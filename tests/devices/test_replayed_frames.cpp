#include <gtest/gtest.h>

#include "core/devices/replayed_frames.h"
#include "tests/devices/small_recording.h"

namespace mirrorarm::devices {
namespace {

class ReplayedFramesTest : public ::testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(writeSmall(folder_, 3)); }
  ReplayedFrames replay(ReplayedFrames::Pace pace) { return {*Recording::open(folder_), pace, time_}; }

  OwnFolder own_;
  std::filesystem::path folder_ = own_.path() / "rec";
  ManualTime time_;
};

TEST_F(ReplayedFramesTest, GivesEveryFrameAndEnds) {
  auto frames = replay(ReplayedFrames::Pace::kAsAsked);
  for (int i = 0; i < 3; ++i) {
    const auto frame = frames.next(Seconds(0.0));
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->exposed_at, smallFrame(i).exposed_at);
    EXPECT_EQ(frame->sequence, smallFrame(i).sequence);
  }
  EXPECT_EQ(frames.next(Seconds(0.0)).error(), camera::NoFrame::kEnded);
  EXPECT_EQ(frames.next(Seconds(0.0)).error(), camera::NoFrame::kEnded);
}

TEST_F(ReplayedFramesTest, KeepsThePausesOfTheRecording) {
  auto frames = replay(ReplayedFrames::Pace::kRecorded);
  const TimePoint start = fromNanoseconds(1'000'000'000);
  time_.set(start);
  const auto first = frames.next(Seconds(0.0));
  ASSERT_TRUE(first);
  EXPECT_EQ(first->exposed_at, start);
  time_.set(start + std::chrono::milliseconds(41));
  EXPECT_EQ(frames.next(Seconds(0.0)).error(), camera::NoFrame::kTimeout);
  time_.set(start + std::chrono::milliseconds(42));
  const auto second = frames.next(Seconds(0.0));
  ASSERT_TRUE(second);
  EXPECT_EQ(second->exposed_at - start, smallFrame(1).exposed_at - smallFrame(0).exposed_at);
}

TEST_F(ReplayedFramesTest, KnowsItsRate) {
  EXPECT_NEAR(replay(ReplayedFrames::Pace::kAsAsked).rate_hz(), 24.0,
              0.01);  // a lost frame does not lower it
}

TEST_F(ReplayedFramesTest, FailsForGoodAtABrokenImage) {
  auto frames = replay(ReplayedFrames::Pace::kAsAsked);
  ASSERT_TRUE(frames.next(Seconds(0.0)));
  std::filesystem::remove(folder_ / "right/000001.png");
  EXPECT_EQ(frames.next(Seconds(0.0)).error(), camera::NoFrame::kFailed);
  EXPECT_EQ(frames.next(Seconds(0.0)).error(), camera::NoFrame::kFailed);
  ASSERT_TRUE(frames.failure());
  EXPECT_EQ(frames.failure()->file.filename(), "000001.png");
}

}  // namespace
}  // namespace mirrorarm::devices
