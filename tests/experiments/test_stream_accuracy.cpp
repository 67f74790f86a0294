#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "core/experiments/stream_accuracy.h"

namespace mirrorarm::experiments {
namespace {

using calibration::TimedPose;
using Eigen::Vector3d;

/// A robot that carries a camera from place to place with rests between, the object lying still.
struct Movement {
  RigidTransform X_FC =
      makeTransform(Eigen::Quaterniond(Eigen::AngleAxisd(1.2, Vector3d(0.2, 1.0, 0.1).normalized())),
                    Vector3d(0.06, 0.08, 0.03));
  RigidTransform X_BT =
      makeTransform(Eigen::Quaterniond(Eigen::AngleAxisd(0.4, Vector3d::UnitX())), Vector3d(0.6, 0.0, 0.1));
  double noise_m = 3e-5;
  double camera_ahead_s = 0.0;
  std::mt19937 random{4};

  static constexpr double kPlace_s = 2.0;

  RigidTransform flangeAtPlace(int i) const {
    const Vector3d axis(std::sin(2.1 * i), std::cos(1.3 * i), std::sin(0.7 * i + 1.0));
    return makeTransform(Eigen::Quaterniond(Eigen::AngleAxisd(0.5, axis.normalized())),
                         Vector3d(0.5 + 0.02 * (i % 4), 0.02 * (i / 4 % 4), 0.4 + 0.02 * (i % 3)));
  }
  /// One second on the way, one at rest.
  RigidTransform flangeAt(double time_s) const {
    const int i = static_cast<int>(time_s / kPlace_s);
    const double u = std::min(1.0, time_s - kPlace_s * i);
    const double share = u * u * u * (10.0 + u * (6.0 * u - 15.0));
    return interpolate(flangeAtPlace(i), flangeAtPlace(i + 1), share);
  }
  std::vector<TimedPose> truth(double seconds) const {
    std::vector<TimedPose> poses;
    for (double t = 0.0; t < seconds; t += 0.004) poses.push_back({t, flangeAt(t)});
    return poses;
  }
  std::vector<TimedPose> camera(double seconds) {
    std::normal_distribution<double> normal(0.0, noise_m);
    std::vector<TimedPose> poses;
    for (double t = 0.01; t < seconds; t += 1.0 / 24.0) {
      RigidTransform X_CT = X_FC.inverse() * flangeAt(t).inverse() * X_BT;
      X_CT.translation() += Vector3d(normal(random), normal(random), normal(random));
      poses.push_back({t + camera_ahead_s, X_CT});
    }
    return poses;
  }
};

TEST(StreamAccuracy, NoiseAveragesOverAStandstill) {
  Movement movement;
  const auto result = accuracyOfStreams(movement.truth(60.0), movement.camera(60.0), movement.X_FC);
  ASSERT_TRUE(result) << result.error();
  EXPECT_GE(result->standstills, 28u);
  EXPECT_LT(result->std_mm.maxCoeff(), 0.02);
  EXPECT_FALSE(result->solved_hand_eye);
}

TEST(StreamAccuracy, AWrongHandEyeIsSeen) {
  Movement movement;
  RigidTransform wrong = movement.X_FC;
  wrong.linear() = wrong.linear() * Eigen::AngleAxisd(0.01, Vector3d::UnitY());
  const auto result = accuracyOfStreams(movement.truth(60.0), movement.camera(60.0), wrong);
  ASSERT_TRUE(result);
  EXPECT_GT(result->rms_mm, 0.5);
}

TEST(StreamAccuracy, ASecondTrackerNeedsNoHandEye) {
  Movement movement;
  movement.camera_ahead_s = 0.035;
  const auto result = accuracyOfStreams(movement.truth(60.0), movement.camera(60.0), std::nullopt);
  ASSERT_TRUE(result) << result.error();
  EXPECT_TRUE(result->solved_hand_eye);
  EXPECT_NEAR(result->clock_offset_s, -0.035, 0.002);
  EXPECT_LT(result->std_mm.maxCoeff(), 0.05);
}

TEST(StreamAccuracy, TooFewRestsAreRefused) {
  Movement movement;
  const auto result = accuracyOfStreams(movement.truth(9.0), movement.camera(9.0), movement.X_FC);
  ASSERT_FALSE(result);
  EXPECT_NE(result.error().find("stands still"), std::string::npos);
}

}  // namespace
}  // namespace mirrorarm::experiments
