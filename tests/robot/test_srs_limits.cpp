#include <numbers>

#include <gtest/gtest.h>

#include "core/robot/kinematics.h"
#include "core/robot/srs_limits.h"
#include "tests/robot/arms.h"

namespace mirrorarm::robot {
namespace {

constexpr double kPi = std::numbers::pi;

/// The branches that may be used at one arm angle, as the ranges tell.
unsigned told(const ArmAngleRanges& ranges, double psi) {
  for (const ArmAngleRange& range : ranges.usable())
    for (const double turn : {0.0, 2.0 * kPi})
      if (psi + turn >= range.from && psi + turn <= range.to) return range.branches;
  return 0;
}

bool isNearAnEnd(const ArmAngleRanges& ranges, double psi) {
  for (const ArmAngleRange& range : ranges.usable())
    for (const double end : {range.from, range.to})
      if (std::abs(std::remainder(psi - end, 2.0 * kPi)) < 1e-6) return true;
  return false;
}

unsigned tried(const SrsPostures& postures, const JointRanges& joints, double psi) {
  const auto all = postures.branches(psi);
  unsigned within = 0;
  for (std::size_t b = 0; b < all.size(); ++b)
    if (joints.have(all[b])) within |= 1U << b;
  return within;
}

}  // namespace

TEST(ArmAngleRanges, AgreeWithWhatIsTriedAllRound) {
  ArmDescription arm = testing::lbr();
  arm.joints[2].lower_rad = -1.0;  // ranges need not be symmetrical
  arm.joints[5].upper_rad = 1.5;
  const SrsArm srs = *srsArm(arm);
  const JointRanges joints = jointRanges(arm);
  const Kinematics kinematics(arm);
  std::mt19937 random(4);
  for (int i = 0; i < 300; ++i) {
    const auto postures = SrsPostures::at(srs, kinematics.flange(testing::randomJoints(arm, random, 1.0)));
    ASSERT_TRUE(postures);
    const ArmAngleRanges ranges(srs, *postures, joints);
    for (double psi = -kPi; psi < kPi; psi += 0.013)
      if (!isNearAnEnd(ranges, psi)) {
        ASSERT_EQ(told(ranges, psi), tried(*postures, joints, psi)) << i << ' ' << psi;
      }
  }
}

TEST(ArmAngleRanges, AreNoneWhenAJointAlwaysLeavesItsRange) {
  ArmDescription arm = testing::lbr();
  const RigidTransform X_BF = Kinematics(arm).flange(testing::working());
  arm.joints[3].lower_rad = -1.0;
  arm.joints[3].upper_rad = 1.0;
  const SrsArm srs = *srsArm(arm);
  const auto postures = SrsPostures::at(srs, X_BF);
  ASSERT_TRUE(postures);
  EXPECT_TRUE(ArmAngleRanges(srs, *postures, jointRanges(arm)).usable().empty());
}

}  // namespace mirrorarm::robot
