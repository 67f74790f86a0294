#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "core/experiments/pose_statistics.h"

using namespace mirrorarm;
using namespace mirrorarm::experiments;
using Eigen::Vector3d;

namespace {

TrialFrame frameAt(const RigidTransform& X_CT, const RigidTransform& X_TU, const Vector3d& error_m) {
  TrialFrame frame;
  frame.X_CT = X_CT;
  frame.answer.status = tracking::TrackStatus::kTracked;
  frame.answer.X_CT = X_CT * X_TU;
  frame.answer.X_CT.translation() += error_m;
  frame.answer.rms_m = 2e-5;
  return frame;
}

}  // namespace

TEST(PoseStatistics, FindTheTaughtFrameAndTheErrorsLeft) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  const auto vector = [&](double size) {
    return Vector3d(size * normal(random), size * normal(random), size * normal(random));
  };
  const auto pose = [&] {
    const Vector3d axis = vector(1.0).normalized();
    return makeTransform(Eigen::Quaterniond(Eigen::AngleAxisd(normal(random), axis)), vector(0.1));
  };
  const RigidTransform X_TU = pose();
  std::vector<TrialFrame> frames;
  for (int i = 0; i < 4000; ++i) {
    const Vector3d error = vector(1e-5).cwiseProduct(Vector3d(1.0, 2.0, 5.0));
    frames.push_back(frameAt(pose(), X_TU, error));
  }
  frames.push_back({});
  const auto found = statisticsOf(frames);
  EXPECT_EQ(found.frames, 4001);
  EXPECT_EQ(found.tracked, 4000);
  EXPECT_NEAR(found.std_mm.x(), 0.01, 0.0005);
  EXPECT_NEAR(found.std_mm.y(), 0.02, 0.001);
  EXPECT_NEAR(found.std_mm.z(), 0.05, 0.0025);
  EXPECT_NEAR(found.rms_mm, std::sqrt(0.01 * 0.01 + 0.02 * 0.02 + 0.05 * 0.05), 0.002);
  EXPECT_NEAR(found.fit_rms_mm, 0.02, 1e-9);
  EXPECT_LT(found.turn_rms_deg, 0.01);
}

TEST(PoseStatistics, SayNothingOfWhatWasNotTracked) {
  const std::vector<TrialFrame> frames(3);
  const auto found = statisticsOf(frames);
  EXPECT_EQ(found.trackedShare(), 0.0);
  EXPECT_TRUE(std::isnan(found.rms_mm));
}
