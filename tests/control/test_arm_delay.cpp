#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "core/control/arm_delay.h"

namespace mirrorarm::control {
namespace {

using robot::Joints;

TEST(ArmDelay, IsUnknownBeforeTheArmHasMoved) {
  ArmDelay delay;
  EXPECT_EQ(delay.value().count(), 0.0);
  for (int i = 0; i < 1000; ++i) delay.add(Joints::Ones(7), Joints::Zero(7), Joints::Ones(7));
  EXPECT_EQ(delay.value().count(), 0.0);
}

TEST(ArmDelay, IsFoundThroughTheEncodersNoise) {
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0.0, 1e-5);
  ArmDelay delay;
  constexpr double trails_s = 0.023;
  const auto at = [](double t) { return Joints(Joints::Constant(7, 0.1 * std::sin(1.5 * t))); };
  for (double t = 0.0; t < 5.0; t += 0.001) {
    const Joints speed = Joints::Constant(7, 0.15 * std::cos(1.5 * t));
    Joints measured = at(t - trails_s);
    for (double& angle : measured) angle += noise(random);
    delay.add(at(t), speed, measured);
  }
  EXPECT_NEAR(delay.value().count(), trails_s, 0.001);
}

TEST(ArmDelay, WhatCannotBeADelayIsBounded) {
  ArmDelay delay;
  for (int i = 0; i < 1000; ++i) delay.add(Joints::Ones(7), Joints::Ones(7), Joints::Zero(7));
  EXPECT_EQ(delay.value().count(), 0.1);
  delay.add(Joints::Ones(7), Joints::Ones(7), Joints());
  EXPECT_EQ(delay.value().count(), 0.1) << "an arm that is not driven tells nothing";
}

}  // namespace
}  // namespace mirrorarm::control
