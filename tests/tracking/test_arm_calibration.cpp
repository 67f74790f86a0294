#include <gtest/gtest.h>

#include "core/tracking/arm_calibration.h"
#include "tests/tracking/synthetic_arm.h"

using namespace mirrorarm;
using namespace mirrorarm::tracking;
using namespace mirrorarm::tracking::test;

namespace {

/// Root mean square errors over working postures [deg].
std::array<double, kArmAngles> errorsOf(const ArmModel& model, SyntheticArm& arm) {
  std::array<double, kArmAngles> squares{};
  Noise noise(5);
  constexpr int kPostures = 200;
  for (int i = 0; i < kPostures; ++i) {
    const Posture p{noise.uniform(20, 120), 8.0,
                    noise.uniform(10, 120), noise.uniform(0, 90),
                    noise.uniform(30, 100), noise.uniform(-40, 40)};
    const double truth_deg[] = {p.flexion_deg, p.carrying_deg,  p.pronation_deg,
                                p.plane_deg,   p.elevation_deg, p.axial_deg};
    const auto angles = anglesOf(model, arm.at(p));
    for (std::size_t k = 0; k < kArmAngles; ++k)
      squares[k] += std::pow(angles.value_rad[k] / kDegree - truth_deg[k], 2) / kPostures;
  }
  for (double& value : squares) value = std::sqrt(value);
  return squares;
}

ArmCalibrationError refusalOf(const ArmMovements& movements, Side side = Side::kRight) {
  const auto arm = calibrateArm(movements, side);
  EXPECT_FALSE(arm);
  return arm ? ArmCalibrationError::kNoPosture : arm.error();
}

}  // namespace

TEST(ArmCalibration, FindsTheBonesOfEitherSide) {
  for (const Side side : {Side::kRight, Side::kLeft}) {
    SyntheticArm arm;
    arm.side = side;
    const auto calibrated = calibrateArm(arm.movements(), side);
    ASSERT_TRUE(calibrated) << id(calibrated.error());
    EXPECT_NEAR(calibrated->quality.upper_arm_m, arm.upper_arm_m, 0.004);
    EXPECT_NEAR(calibrated->quality.flexion_range_rad / kDegree, 110.0, 1.0);
    const auto errors = errorsOf(calibrated->model, arm);
    for (std::size_t k = 0; k < kArmAngles; ++k) EXPECT_LT(errors[k], 1.5) << id(static_cast<ArmAngle>(k));
  }
}

TEST(ArmCalibration, BearsSkinThatMoves) {
  SyntheticArm arm;
  arm.skin_rad = 0.05;
  const auto calibrated = calibrateArm(arm.movements(), Side::kRight);
  ASSERT_TRUE(calibrated) << id(calibrated.error());
  const auto errors = errorsOf(calibrated->model, arm);
  for (std::size_t k = 0; k < kArmAngles; ++k) EXPECT_LT(errors[k], 6.0) << id(static_cast<ArmAngle>(k));
}

TEST(ArmCalibration, RefusesWhatShowsNoJoint) {
  SyntheticArm arm;
  const ArmMovements good = arm.movements();
  ArmMovements bad = good;
  bad.posture.clear();
  EXPECT_EQ(refusalOf(bad), ArmCalibrationError::kNoPosture);
  bad = good;
  bad.flexion = good.posture;
  EXPECT_EQ(refusalOf(bad), ArmCalibrationError::kSmallFlexion);
  bad = good;
  bad.flexion.resize(5);
  EXPECT_EQ(refusalOf(bad), ArmCalibrationError::kSmallFlexion);
  bad = good;
  for (std::size_t i = 0; i < bad.flexion.size(); ++i)
    bad.flexion[i].X_CF.linear() *= about({0.3, -0.6, 0.1}, 40.0 * std::sin(0.7 * static_cast<double>(i)));
  EXPECT_EQ(refusalOf(bad), ArmCalibrationError::kFlexionNotHinge);
  bad = good;
  bad.rotation = good.posture;
  EXPECT_EQ(refusalOf(bad), ArmCalibrationError::kSmallRotation);
  bad = good;
  for (std::size_t i = 0; i < bad.rotation.size(); ++i)
    bad.rotation[i].X_CF.linear() *= about({0.3, -0.6, 0.1}, 40.0 * std::sin(0.7 * static_cast<double>(i)));
  EXPECT_EQ(refusalOf(bad), ArmCalibrationError::kRotationNotHinge);
  EXPECT_EQ(refusalOf(good, Side::kLeft), ArmCalibrationError::kRotationReversed);
  bad = good;
  bad.circles = good.posture;
  EXPECT_EQ(refusalOf(bad), ArmCalibrationError::kSmallCircles);
  bad = good;
  for (auto& frame : bad.circles) frame.X_CU.translation() += arm.noise.gaussian(0.05);
  EXPECT_EQ(refusalOf(bad), ArmCalibrationError::kShoulderMoved);
  SyntheticArm tiny;
  tiny.upper_arm_m = 0.1;
  EXPECT_EQ(refusalOf(tiny.movements()), ArmCalibrationError::kUpperArmLength);
}
