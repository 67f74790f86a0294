#include <gtest/gtest.h>

#include "core/tracking/arm_joints.h"
#include "core/tracking/functional_axes.h"
#include "tests/tracking/synthetic_arm.h"

using namespace mirrorarm;
using namespace mirrorarm::tracking;
using namespace mirrorarm::tracking::test;

namespace {

/// The model that knows the synthetic arm's bones.
ArmModel truth(const SyntheticArm& arm) {
  ArmModel model;
  model.side = arm.side;
  model.R_Uh = arm.X_hU.linear().transpose();
  model.R_Ff = arm.X_fF.linear().transpose();
  return model;
}

double deg(const ArmAngles& angles, ArmAngle angle) { return angles.value_rad[angle] / kDegree; }

}  // namespace

TEST(ArmJoints, TellTheAnglesOfKnownBonesOnEitherSide) {
  Noise noise(2);
  for (const Side side : {Side::kRight, Side::kLeft}) {
    SyntheticArm arm;
    arm.side = side;
    arm.turn_noise_rad = 0.0;
    for (int i = 0; i < 200; ++i) {
      const Posture posture{noise.uniform(-5, 140),  noise.uniform(-15, 20), noise.uniform(-80, 80),
                            noise.uniform(-60, 130), noise.uniform(15, 165), noise.uniform(-90, 90)};
      const auto angles = anglesOf(truth(arm), arm.at(posture));
      EXPECT_NEAR(deg(angles, kElbowFlexion), posture.flexion_deg, 1e-6);
      EXPECT_NEAR(deg(angles, kCarryingAngle), posture.carrying_deg, 1e-6);
      EXPECT_NEAR(deg(angles, kPronation), posture.pronation_deg, 1e-6);
      EXPECT_NEAR(deg(angles, kPlaneOfElevation), posture.plane_deg, 1e-6);
      EXPECT_NEAR(deg(angles, kElevation), posture.elevation_deg, 1e-6);
      EXPECT_NEAR(deg(angles, kAxialRotation), posture.axial_deg, 1e-6);
      EXPECT_FALSE(angles.shoulder_singular);
      EXPECT_FALSE(angles.elbow_singular);
    }
  }
}

TEST(ArmJoints, AnglesMeanWhatTheirNamesSay) {
  SyntheticArm arm;
  arm.turn_noise_rad = 0.0;
  const Vector3d up_C = arm.X_Ct.linear().col(1), right_C = arm.X_Ct.linear().col(2),
                 ahead_C = arm.X_Ct.linear().col(0);
  const auto elbow_to_hand = [&](const Posture& posture) {
    return Vector3d(-(arm.at(posture).X_CF.linear() * arm.X_fF.linear().transpose()).col(1));
  };
  EXPECT_GT(elbow_to_hand({.flexion_deg = 90.0, .carrying_deg = 0.0}).dot(ahead_C), 0.999);
  EXPECT_GT(elbow_to_hand({.carrying_deg = 0.0, .elevation_deg = 90.0}).dot(right_C), 0.999);
  EXPECT_GT(elbow_to_hand({.carrying_deg = 0.0, .plane_deg = 90.0, .elevation_deg = 90.0}).dot(ahead_C),
            0.999);
  EXPECT_GT(elbow_to_hand({.flexion_deg = 0.0, .carrying_deg = 0.0}).dot(-up_C), 0.999);
}

TEST(ArmJoints, DeviationsFollowThePosesCovariance) {
  for (const Side side : {Side::kRight, Side::kLeft}) {
    SyntheticArm arm;
    arm.side = side;
    const ArmModel model = truth(arm);
    const Posture posture{70.0, 10.0, 40.0, 50.0, 60.0, -20.0};
    const double expected_deg[] = {70.0, 10.0, 40.0, 50.0, 60.0, -20.0};
    std::array<double, kArmAngles> squares{};
    constexpr int kTrials = 4000;
    for (int i = 0; i < kTrials; ++i) {
      const auto angles = anglesOf(model, arm.at(posture));
      for (std::size_t k = 0; k < kArmAngles; ++k)
        squares[k] += std::pow(angles.value_rad[k] - expected_deg[k] * kDegree, 2) / kTrials;
    }
    const auto angles = anglesOf(model, arm.at(posture), arm.turn_noise_rad);
    for (std::size_t k = 0; k < kArmAngles; ++k)
      EXPECT_NEAR(angles.sigma_rad[k] / std::sqrt(squares[k]), 1.0, 0.06) << id(static_cast<ArmAngle>(k));
  }
}

TEST(ArmJoints, SingularPosturesAreNamed) {
  SyntheticArm arm;
  for (const double elevation : {0.0, 4.0, 176.0}) {
    const auto angles =
        anglesOf(truth(arm), arm.at({.flexion_deg = 30.0, .elevation_deg = elevation}), 0.001);
    EXPECT_TRUE(angles.shoulder_singular);
    EXPECT_GT(angles.sigma_rad[kPlaneOfElevation], 0.008);
    EXPECT_LT(angles.sigma_rad[kElevation], 0.002);
    for (const double sigma : angles.sigma_rad) EXPECT_LE(sigma, 1.82);
  }
  EXPECT_TRUE(anglesOf(truth(arm), arm.at({.carrying_deg = 85.0})).elbow_singular);
}

TEST(FunctionalAxes, FindAHingeAndACentre) {
  Noise noise(3);
  const Vector3d axis = Vector3d(0.2, 0.5, -0.7).normalized(), on_P(0.1, -0.05, 0.3), on_C(0.02, 0.2, -0.1);
  std::vector<RigidTransform> hinge, ball;
  for (int i = 0; i < 80; ++i) {
    const Eigen::Matrix3d R = about(axis, noise.uniform(-60, 60)) * about({1.0, 0.0, 0.0}, 100.0);
    hinge.push_back(makeTransform(R, on_P - R * on_C + noise.gaussian(0.0002)));
    const Eigen::Matrix3d S = about(noise.gaussian(1.0), noise.uniform(0, 40));
    ball.push_back(makeTransform(S, on_P - S * on_C + noise.gaussian(0.0002)));
  }
  const auto spread = rotationSpread(hinge);
  EXPECT_GT(std::abs(spread.axis_P.dot(axis)), 0.99999);
  EXPECT_NEAR(spread.range_rad / kDegree, 118.0, 4.0);
  EXPECT_LT(spread.across_rms_rad, 1e-6);
  EXPECT_FALSE(rotationCentre(hinge));
  const auto on_axis = rotationCentre(hinge, spread.axis_P);
  ASSERT_TRUE(on_axis);
  EXPECT_LT((on_axis->in_P - on_P).cross(axis).norm(), 0.0005);
  const auto centre = rotationCentre(ball);
  ASSERT_TRUE(centre);
  EXPECT_LT((centre->in_P - on_P).norm(), 0.0005);
  EXPECT_LT((centre->in_C - on_C).norm(), 0.0005);
  EXPECT_LT(centre->rms_m, 0.001);
}
