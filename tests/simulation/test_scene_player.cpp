#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

#include "core/robot/kinematics.h"
#include "core/robot/urdf.h"
#include "core/simulation/bench_layout.h"
#include "core/simulation/scene_player.h"

namespace mirrorarm::simulation {
namespace {

namespace fs = std::filesystem;

Scene shipped(const char* name) {
  return *readScene(fs::path(RESOURCES) / "scenes" / (std::string(name) + ".yaml"), RESOURCES);
}

ScenePlayer play(const Scene& scene) {
  auto player = ScenePlayer::make(scene, RESOURCES);
  EXPECT_TRUE(player) << describe(player.error());
  return std::move(*player);
}

/// Markers that shine in both images where the truth has them.
int shining(const ScenePlayer& player, const ScenePlayer::Shot& shot) {
  const auto bright = [](const camera::GreyImage& image, const Eigen::Vector2d& pixel) {
    return image.view().at(static_cast<int>(std::lround(pixel.x())),
                           static_cast<int>(std::lround(pixel.y()))) > 25;
  };
  int count = 0;
  for (const auto& disc : player.discs_T()) {
    const Eigen::Vector3d p_C = shot.X_CT * disc.p_B;
    const Eigen::Vector3d p_R = player.rig().X_RC * p_C;
    if (bright(shot.frame.left, *player.rig().left.project(p_C)) &&
        bright(shot.frame.right, *player.rig().right.project(p_R)))
      ++count;
  }
  return count;
}

TEST(ScenePlayer, TheCuboidShowsThePlateAtEveryStation) {
  const Scene scene = shipped("paper_cuboid");
  auto player = play(scene);
  for (int i = 0; i < scene.frames; i += 13) {
    const auto shot = player.shoot(i);
    EXPECT_EQ(shot.visible, 10);
    EXPECT_EQ(shining(player, shot), 10) << i;
    EXPECT_NEAR(shot.X_CT.translation().z(), 0.4, 0.021);
    EXPECT_EQ(shot.frame.sequence, static_cast<std::uint64_t>(i));
  }
}

TEST(ScenePlayer, TheRobotsFlangeAndTheHandEyeGiveTheSameTarget) {
  const Scene scene = shipped("paper_cuboid");
  auto player = play(scene);
  const RigidTransform X_FC = bench_layout::hand(RESOURCES)->X_FC;
  for (int i = 0; i < scene.frames; i += 31) {
    const auto shot = player.shoot(i);
    ASSERT_TRUE(shot.robot);
    const RigidTransform X_BT = shot.robot->X_BF * X_FC * shot.X_CT;
    EXPECT_LT((X_BT.translation() - scene.target.X_WT.translation()).norm(), 1e-9);
    EXPECT_LT(angleBetween(X_BT, scene.target.X_WT), 1e-7);
  }
}

TEST(ScenePlayer, AForearmMovesAndKeepsItsMarkersInView) {
  const Scene scene = shipped("forearm_exercise");
  auto player = play(scene);
  const auto start = player.shoot(0), later = player.shoot(38);
  EXPECT_GT((start.X_CT.translation() - later.X_CT.translation()).norm(), 0.08);
  EXPECT_GE(shining(player, later), later.visible);
}

TEST(ScenePlayer, AUr5HoldsItsTargetWhereItsJointsSay) {
  const Scene scene = shipped("ur5_target");
  auto player = play(scene);
  const auto arm = robot::readUrdf(fs::path(RESOURCES) / "robots/ur5.urdf");
  const robot::Kinematics kinematics(*arm);
  for (const int i : {0, 20, 60}) {
    const auto shot = player.shoot(i);
    ASSERT_TRUE(shot.robot);
    EXPECT_TRUE(kinematics.flange(shot.robot->q_rad).isApprox(shot.robot->X_BF, 1e-9));
    const RigidTransform X_WT = scene.target.X_WU * shot.robot->X_BF * scene.target.X_FT;
    EXPECT_TRUE((scene.camera.X_WC * shot.X_CT).isApprox(X_WT, 1e-9));
    EXPECT_EQ(shining(player, shot), 10);
  }
}

TEST(ScenePlayer, CoveredMarkersAreDarkAndOthersEachFrame) {
  Scene scene = shipped("paper_cuboid");
  scene.covered_share = 0.5;
  auto player = play(scene);
  const auto a = player.shoot(0), b = player.shoot(1);
  EXPECT_EQ(a.visible, 5);
  EXPECT_EQ(shining(player, a), 5);
  EXPECT_EQ(shining(player, b), 5);
  EXPECT_NE(std::memcmp(a.frame.left.view().data, b.frame.left.view().data, 1296 * 964), 0);
}

TEST(ScenePlayer, ASceneIsTheSameEveryTime) {
  const Scene scene = shipped("forearm_exercise");
  const auto a = play(scene).shoot(9), b = play(scene).shoot(9);
  EXPECT_EQ(std::memcmp(a.frame.right.view().data, b.frame.right.view().data, 1296 * 964), 0);
  EXPECT_TRUE(a.X_CT.isApprox(b.X_CT, 0.0));
}

TEST(ScenePlayer, ARecordedForearmHasTheBestFitAsTruth) {
  Scene scene = shipped("forearm_exercise");
  scene.target.motion = fs::path(SHARED_DATA) / "pyomeca-upper-limb/markers.trc";
  if (!fs::exists(scene.target.motion)) GTEST_SKIP() << scene.target.motion << " is absent";
  auto player = play(scene);
  const auto shot = player.shoot(20);
  EXPECT_EQ(shot.visible, 10);
  EXPECT_GE(shining(player, shot), 7);  // the skin carries some a disc's radius away from the rigid fit
}

TEST(ScenePlayer, RefusesWhatARobotDoesNotReach) {
  Scene scene = shipped("paper_cuboid");
  scene.camera.X_WC.translation().x() = 3.0;
  EXPECT_FALSE(ScenePlayer::make(scene, RESOURCES));
  scene = shipped("ur5_target");
  scene.target.legs[1].displacement_m.x() = 3.0;
  EXPECT_FALSE(ScenePlayer::make(scene, RESOURCES));
  scene = shipped("ur5_target");
  scene.rig = "/nowhere/rig.yaml";
  EXPECT_FALSE(ScenePlayer::make(scene, RESOURCES));
}

}  // namespace
}  // namespace mirrorarm::simulation
