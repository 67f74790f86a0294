#include <fstream>
#include <random>
#include <unistd.h>

#include <gtest/gtest.h>

#include "core/simulation/scene.h"

namespace mirrorarm::simulation {
namespace {

namespace fs = std::filesystem;

constexpr const char* kScene = R"(format: mirrorarm/scene/1
rig: fisheye
seed: 3
frames: 5
rate_hz: 30
exposure_s: 0.001
light: {spread_sigma_px: 0.8, bright_level: 180}
sensor: {background: 5, electrons_per_level: 20, read_noise: 1}
camera:
  on_robot: false
  pose: {translation_m: [0, 0, 0], rotation_xyzw: [0, 0, 0, 1]}
target:
  name: plate
  marker_diameter_m: 0.006
  carried_by: forearm
  pose: {translation_m: [0.05, 0, 0.4], rotation_xyzw: [1, 0, 0, 0]}
  legs:
    - {displacement_m: [0.1, 0, 0], duration_s: 1, rest_s: 0.2, turn_rad: 0.1}
  markers:
    - {position_m: [0.01, 0, 0], normal: [0, 0, 1]}
    - {position_m: [0.04, 0.02, 0], normal: [0, 0, 1]}
    - {position_m: [-0.02, -0.05, 0.01], normal: [0, 0, 1]}
clutter:
  - {outline: rectangle, centre_m: [0.2, 0, 1], u_m: [0.1, 0, 0], v_m: [0, 0.01, 0], strength: 0.5, glows: true}
covered_share: 0.25
)";

class SceneFileTest : public ::testing::Test {
 protected:
  void TearDown() override { fs::remove(file_); }
  FromFile<Scene> read(const std::string& text) {
    std::ofstream(file_, std::ios::binary) << text;
    return readScene(file_, RESOURCES);
  }
  fs::path file_ = fs::temp_directory_path() / ("mirrorarm_scene_" + std::to_string(::getpid()) + ".yaml");
};

TEST_F(SceneFileTest, ReadsEveryKey) {
  const auto scene = read(kScene);
  ASSERT_TRUE(scene) << describe(scene.error());
  EXPECT_EQ(scene->rig.filename(), "fisheye.yaml");
  EXPECT_EQ(scene->frames, 5);
  EXPECT_EQ(scene->rate_hz, 30.0);
  EXPECT_EQ(scene->light.bright_level, 180.0);
  EXPECT_EQ(scene->sensor.read_noise, 1.0);
  EXPECT_EQ(scene->target.carried_by, Carrier::kForearm);
  EXPECT_EQ(scene->target.legs.at(0).forearm_turn_rad, 0.1);
  ASSERT_EQ(scene->target.discs_T.size(), 3u);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const auto& disc : scene->target.discs_T) sum += disc.p_B;
  EXPECT_LT(sum.norm(), 1e-12);
  EXPECT_EQ(scene->target.discs_T[0].diameter_m, 0.006);
  EXPECT_FALSE(scene->clutter_W.at(0).retroreflective);
  EXPECT_EQ(scene->covered_share, 0.25);
}

TEST_F(SceneFileTest, ReadsTheScenesThatComeWithTheProgram) {
  for (const char* name : {"paper_cuboid", "forearm_exercise", "ur5_target"}) {
    const auto scene = readScene(fs::path(RESOURCES) / "scenes" / (std::string(name) + ".yaml"), RESOURCES);
    ASSERT_TRUE(scene) << describe(scene.error());
    EXPECT_EQ(scene->target.discs_T.size(), 10u);
  }
}

TEST_F(SceneFileTest, RefusesWithTheLine) {
  const struct {
    const char* from;
    const char* to;
    int line;
  } wrongs[] = {{"scene/1", "scene/2", 1},
                {"seed: 3", "sed: 3", 3},
                {"frames: 5", "frames: 0", 4},
                {"frames: 5", "frames: 2.5", 4},
                {"rate_hz: 30", "rate_hz: -1", 5},
                {"exposure_s: 0.001", "exposure_s: 0.1", 6},
                {"on_robot: false", "on_robot: perhaps", 10},
                {"rotation_xyzw: [0, 0, 0, 1]", "rotation_xyzw: [0, 0, 0, 2]", 11},
                {"name: plate", "name: \"a,b\"", 13},
                {"carried_by: forearm", "carried_by: table", 18},
                {"carried_by: forearm", "carried_by: dog", 15},
                {"[0.05, 0, 0.4]", "[50, 0, 400]", 16},
                {"duration_s: 1,", "duration_s: 0,", 18},
                {"[0.04, 0.02, 0]", "[0.012, 0, 0]", 21},
                {"normal: [0, 0, 1]", "normal: [0, 0, 2]", 20},
                {"v_m: [0, 0.01, 0]", "v_m: [0.01, 0, 0]", 24},
                {"covered_share: 0.25", "covered_share: 25", 25}};
  for (const auto& wrong : wrongs) {
    std::string text = kScene;
    text.replace(text.find(wrong.from), std::string(wrong.from).size(), wrong.to);
    const auto scene = read(text);
    ASSERT_FALSE(scene) << wrong.to;
    EXPECT_EQ(scene.error().line, wrong.line) << wrong.to << ": " << describe(scene.error());
  }
  EXPECT_FALSE(readScene("/nowhere/scene.yaml", RESOURCES));
}

TEST_F(SceneFileTest, SurvivesRandomChanges) {
  const std::string good = kScene;
  std::mt19937 random(11);
  for (int i = 0; i < 400; ++i) {
    std::string bad = good;
    for (int n = 0; n < 1 + i % 3; ++n) bad[random() % bad.size()] = static_cast<char>(random());
    if (i % 5 == 0) bad.resize(random() % bad.size());
    const auto scene = read(bad);
    if (scene)
      EXPECT_GE(scene->frames, 1);
    else
      EXPECT_FALSE(scene.error().reason.empty());
  }
}

TEST(SceneGrid, VisitsEveryStationOnceInShortSteps) {
  const Scene::Grid grid{{0.06, 0.06, 0.04}, 0.02, 1};
  const auto stations = stationsOf(grid);
  ASSERT_EQ(stations.size(), 48u);
  for (std::size_t i = 0; i < stations.size(); ++i) {
    EXPECT_LE(std::abs(stations[i].x()), 0.030001);
    EXPECT_LE(std::abs(stations[i].z()), 0.020001);
    if (i > 0) {
      EXPECT_NEAR((stations[i] - stations[i - 1]).norm(), 0.02, 1e-9) << i;
    }
  }
  EXPECT_EQ(stationsOf({Eigen::Vector3d::Zero(), 0.02, 1}).size(), 1u);
}

}  // namespace
}  // namespace mirrorarm::simulation
