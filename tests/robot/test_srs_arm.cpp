#include <gtest/gtest.h>

#include "core/robot/srs_arm.h"
#include "tests/robot/arms.h"

namespace mirrorarm::robot {

TEST(SrsArm, KnowsTheLbrByItsLinksAndSigns) {
  const auto srs = srsArm(testing::lbr());
  ASSERT_TRUE(srs);
  EXPECT_NEAR(srs->upper_arm_m, 0.400, 1e-12);
  EXPECT_NEAR(srs->forearm_m, 0.390, 1e-12);
  EXPECT_EQ(srs->sign, (std::array<double, 7>{1, 1, 1, -1, 1, 1, 1}));
  EXPECT_NEAR(srs->X_UB.inverse().translation().z(), 0.3105, 1e-12);
  EXPECT_NEAR(srs->X_FW.translation().z(), -0.078, 1e-12);
  EXPECT_LT((srs->X_UB.linear() * Eigen::Vector3d::UnitX() - srs->ahead_U).norm(), 1e-12);
}

TEST(SrsArm, IsRecognisedOnAWallToo) {
  ArmDescription arm = testing::lbr();
  const Eigen::Quaterniond tilted(Eigen::AngleAxisd(1.2, Eigen::Vector3d(1.0, 2.0, -0.5).normalized()));
  arm.joints[0].X_parent = makeTransform(tilted, {0.3, -1.0, 2.0}) * arm.joints[0].X_parent;
  const auto srs = srsArm(arm);
  ASSERT_TRUE(srs);
  EXPECT_NEAR(srs->forearm_m, 0.390, 1e-12);
  EXPECT_LT(std::abs(srs->ahead_U.z()), 1e-12);
}

TEST(SrsArm, IsNothingElse) {
  EXPECT_FALSE(srsArm(testing::arm("ur5")));
  ArmDescription offset = testing::lbr();
  offset.joints[3].X_parent.translation().x() += 1e-4;
  EXPECT_FALSE(srsArm(offset));
  ArmDescription crooked = testing::lbr();
  crooked.joints[1].axis = Eigen::Vector3d(0.001, -1.0, 0.0).normalized();
  EXPECT_FALSE(srsArm(crooked));
  ArmDescription no_upper_arm = testing::lbr();
  no_upper_arm.joints[2].X_parent.translation().z() = no_upper_arm.joints[3].X_parent.translation().z() = 0.0;
  EXPECT_FALSE(srsArm(no_upper_arm));
}

}  // namespace mirrorarm::robot
