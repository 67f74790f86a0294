#include <gtest/gtest.h>

#include "tests/therapy/synthetic_session.h"

namespace mirrorarm::therapy {
namespace {

TEST(SessionMeasures, FindTheTruthUnderSensorNoise) {
  const auto measures = SyntheticSession{}.measures();
  EXPECT_NEAR(measures.lag_ms, 137.0, 5.0);
  EXPECT_NEAR(measures.gain, 1.0, 0.005);
  EXPECT_EQ(measures.repetitions, 10);
  EXPECT_NEAR(measures.range_mm, 100.0, 1.5);
  EXPECT_NEAR(measures.active_s, 40.0, 0.1);
  EXPECT_NEAR(measures.tool_speed_m_s, 0.1 * std::numbers::pi / 4.0, 0.015);
  EXPECT_NEAR(measures.path_mm, 2000.0, 40.0);
  EXPECT_EQ(measures.frames, 960);
  EXPECT_EQ(measures.tracked_share, 1.0);
  EXPECT_NEAR(measures.rms_mm, 0.2, 1e-9);
  EXPECT_NEAR(measures.joint_speed_ratio, 0.5, 0.001);
  EXPECT_NEAR(measures.joint_acceleration_ratio, 0.5, 0.001);
}

// Speed rms of the swing times the delay is what the patient feels; without the delay the noise remains.
TEST(SessionMeasures, FeltErrorIsMostlyDelayAndShapeErrorIsNot) {
  const auto measures = SyntheticSession{}.measures();
  const double speed_rms_mm_s = 100.0 * std::numbers::pi / 4.0 / std::sqrt(2.0);
  EXPECT_NEAR(measures.felt_error_mm, speed_rms_mm_s * 0.137, 0.3);
  EXPECT_NEAR(measures.shape_error_mm, 0.3 * std::sqrt(6.0), 0.15);
}

TEST(SessionMeasures, AWeakFollowerShowsInTheGain) {
  SyntheticSession session;
  session.gain = 0.8;
  EXPECT_NEAR(session.measures().gain, 0.8, 0.005);
}

TEST(SessionMeasures, PausesAndLostFramesDoNotTakePart) {
  auto samples = SyntheticSession{}.samples();
  for (std::size_t i = 300; i < 400; ++i) {
    samples[i].training = false;
    samples[i].X_BE_goal.translation().setConstant(9.0);
  }
  for (std::size_t i = 500; i < 520; ++i) {
    samples[i].status = tracking::TrackStatus::kLost;
    samples[i].X_BT = samples[i].X_BE_goal = RigidTransform::Identity();
  }
  samples.erase(samples.begin() + 700, samples.begin() + 730);
  const auto measures = SyntheticSession::measured(samples);
  EXPECT_NEAR(measures.lag_ms, 137.0, 5.0);
  EXPECT_NEAR(measures.range_mm, 100.0, 1.5);
  EXPECT_LT(measures.shape_error_mm, 1.0);
  EXPECT_NEAR(measures.active_s, (960 - 102 - 31) / 24.0, 0.2);
  EXPECT_NEAR(measures.tracked_share, (930.0 - 20.0) / 930.0, 1e-9);
}

TEST(SessionMeasures, AForearmThatOnlyTurnsIsCountedToo) {
  SyntheticSession session;
  session.shift_m = 0.0;
  session.turn_rad = 0.5;
  const auto measures = session.measures();
  EXPECT_EQ(measures.repetitions, 10);
  EXPECT_EQ(measures.lag_ms, 0.0);
}

TEST(SessionMeasures, NothingTrainedLeavesTheMovementAtZero) {
  auto samples = SyntheticSession{}.samples();
  for (auto& sample : samples) sample.training = false;
  const auto measures = SyntheticSession::measured(samples);
  EXPECT_EQ(measures.frames, 960);
  EXPECT_EQ(measures.tracked_share, 1.0);
  EXPECT_EQ(measures.path_mm, 0.0);
  EXPECT_EQ(measures.repetitions, 0);
  EXPECT_EQ(SyntheticSession::measured({}).frames, 0);
}

TEST(SessionMeasures, ForceIsTheLargestOfAllAndHelpTheMeanOfTraining) {
  auto samples = SyntheticSession().samples();
  EXPECT_FALSE(SyntheticSession::measured(samples).force_share);
  EXPECT_FALSE(SyntheticSession::measured(samples).help_level);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples[i].training = i >= 100;
    samples[i].force_share = i == 50 ? 0.9 : 0.3;
    samples[i].help_level = i < 100 ? 1.0 : i % 2 == 0 ? 0.2 : 0.4;
    samples[i].help_adapts = i % 4 == 0;
  }
  samples.back().help_level.reset();
  samples.back().training = true;
  const auto measures = SyntheticSession::measured(samples);
  EXPECT_DOUBLE_EQ(measures.force_share.value(), 0.9) << "a force before training, or after a stop, counts";
  EXPECT_NEAR(measures.help_level.value(), 0.3, 0.001);
  EXPECT_NEAR(measures.help_adapting_share.value(), 0.25, 0.001);
}

TEST(SessionMeasures, WithoutLimitsThereAreNoRatios) {
  const auto measures = measure(SyntheticSession{}.samples(), robot::Joints(), robot::Joints());
  EXPECT_EQ(measures.joint_speed_ratio, 0.0);
  EXPECT_GT(measures.lag_ms, 100.0);
}

}  // namespace
}  // namespace mirrorarm::therapy
