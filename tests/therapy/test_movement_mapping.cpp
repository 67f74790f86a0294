#include <gtest/gtest.h>

#include "core/therapy/movement_mapping.h"

namespace mirrorarm::therapy {
namespace {

RigidTransform pose(const Eigen::Vector3d& axis_angle, const Eigen::Vector3d& p) {
  return makeTransform(Eigen::AngleAxisd(axis_angle.norm(), axis_angle.normalized()).toRotationMatrix(), p);
}

Alignment alignment() {
  return {
      pose({0.3, -0.2, 0.5}, {0.6, 0.2, 0.3}), pose({-0.1, 0.4, 0.2}, {0.6, -0.2, 0.35}), {0.0, 2.0, 0.0}};
}

TEST(MovementMapping, NothingMovesWhileTheTargetStandsStill) {
  for (const auto mapping : {Mapping::kFollow, Mapping::kMirror})
    EXPECT_TRUE(goalOf(alignment(), mapping, alignment().X_BT).isApprox(alignment().X_BE, 1e-12));
}

TEST(MovementMapping, FollowKeepsThePlaceInTheTargetsFrame) {
  const auto X_BT_now = pose({0.5, 0.1, -0.3}, {0.7, 0.25, 0.4});
  const auto goal = goalOf(alignment(), Mapping::kFollow, X_BT_now);
  EXPECT_TRUE((X_BT_now.inverse() * goal).isApprox(alignment().X_BT.inverse() * alignment().X_BE, 1e-12));
}

TEST(MovementMapping, MirrorReflectsTheShiftInTheMidplane) {
  auto X_BT_now = alignment().X_BT;
  X_BT_now.pretranslate(Eigen::Vector3d(0.01, 0.02, 0.03));
  const auto goal = goalOf(alignment(), Mapping::kMirror, X_BT_now);
  EXPECT_TRUE(
      goal.translation().isApprox(alignment().X_BE.translation() + Eigen::Vector3d(0.01, -0.02, 0.03)));
  EXPECT_NEAR(angleBetween(goal, alignment().X_BE), 0.0, 1e-9);
}

// A turn about the normal keeps its sense in a mirror; one about an axis in the plane turns the other way.
TEST(MovementMapping, MirrorReflectsTheTurn) {
  const auto turned = [](const Eigen::Vector3d& axis, double angle) {
    auto X = alignment().X_BT;
    X.linear() = Eigen::AngleAxisd(angle, axis) * X.linear();
    const auto goal = goalOf(alignment(), Mapping::kMirror, X);
    return Eigen::Matrix3d(goal.linear() * alignment().X_BE.linear().transpose());
  };
  EXPECT_TRUE(turned(Eigen::Vector3d::UnitY(), 0.4)
                  .isApprox(Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitY()).toRotationMatrix(), 1e-12));
  EXPECT_TRUE(turned(Eigen::Vector3d::UnitX(), 0.4)
                  .isApprox(Eigen::AngleAxisd(-0.4, Eigen::Vector3d::UnitX()).toRotationMatrix(), 1e-12));
}

TEST(MovementMapping, MirroredTwiceIsTheMovementItself) {
  const auto X_BT_now = pose({0.5, 0.1, -0.3}, {0.7, 0.25, 0.4});
  const Alignment there{alignment().X_BT, alignment().X_BT, {0.3, 0.9, -0.1}};
  const Alignment back{alignment().X_BT, alignment().X_BT, there.midplane_normal_B};
  const auto once = goalOf(there, Mapping::kMirror, X_BT_now);
  EXPECT_TRUE(goalOf(back, Mapping::kMirror, once).isApprox(X_BT_now, 1e-12));
}

TEST(MovementMapping, TheGoalIsRigid) {
  const auto X_BT_now = pose({0.5, 0.1, -0.3}, {0.7, 0.25, 0.4});
  for (const auto mapping : {Mapping::kFollow, Mapping::kMirror})
    EXPECT_TRUE(isRigid(goalOf(alignment(), mapping, X_BT_now)));
}

TEST(MovementMapping, NamesAreFoundAgain) {
  for (const auto mapping : {Mapping::kFollow, Mapping::kMirror}) EXPECT_EQ(mappingOf(id(mapping)), mapping);
  EXPECT_FALSE(mappingOf("sideways"));
}

}  // namespace
}  // namespace mirrorarm::therapy
