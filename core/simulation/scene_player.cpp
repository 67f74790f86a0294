#include "core/simulation/scene_player.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/camera/rig_file.h"
#include "core/robot/kinematics.h"
#include "core/robot/urdf.h"
#include "core/simulation/bench_layout.h"
#include "core/simulation/counter_random.h"

namespace mirrorarm::simulation {
namespace {

constexpr std::uint64_t kCoverStream = 0x436F766572u;

/// The cameras at one station.
struct Station {
  RigidTransform X_WC = RigidTransform::Identity();
  std::optional<RobotPose> robot;
};

std::vector<RigidTransform> cameraPoses(const Scene::Camera& camera) {
  if (!camera.grid) return {camera.X_WC};
  std::vector<RigidTransform> poses;
  for (const auto& displacement_W : stationsOf(*camera.grid))
    poses.push_back(Eigen::Translation3d(displacement_W) * camera.X_WC);
  return poses;
}

/// Where the robot has to go for the camera poses; its own forward kinematics then say where the cameras are.
FromFile<std::vector<Station>> stationsOnRobot(const Scene& scene, const std::vector<RigidTransform>& poses,
                                               const std::filesystem::path& resources) {
  const auto arm = robot::readUrdf(resources / "robots/lbr4plus.urdf");
  if (!arm) return unexpected(arm.error());
  const auto hand = bench_layout::hand(resources);
  if (!hand) return unexpected(hand.error());
  const robot::Kinematics kinematics(*arm);
  auto q = bench_layout::startPosture(kinematics);
  std::vector<Station> stations;
  for (const RigidTransform& X_WC : poses) {
    if (q) q = kinematics.inverse(X_WC * hand->X_FC.inverse(), *q);
    if (!q)
      return unexpected(
          FileError{scene.file, 0, "camera.pose or a station of its grid is out of the robot's reach"});
    const RigidTransform X_BF = kinematics.flange(*q);
    stations.push_back({X_BF * hand->X_FC, RobotPose{*q, X_BF}});
  }
  return stations;
}

FromFile<std::vector<Station>> stationsFor(const Scene& scene, const std::filesystem::path& resources) {
  const auto poses = cameraPoses(scene.camera);
  if (scene.camera.on_robot) return stationsOnRobot(scene, poses, resources);
  std::vector<Station> stations;
  for (const RigidTransform& X_WC : poses) stations.push_back({X_WC, std::nullopt});
  return stations;
}

/// Which markers are covered in frame `i`: the share's number of them, by lot.
std::vector<bool> coveredIn(const Scene& scene, int i, std::size_t markers) {
  std::vector<std::size_t> order(markers);
  const std::uint64_t seed = counterRandom(scene.seed ^ kCoverStream, static_cast<std::uint64_t>(i));
  for (std::size_t k = 0; k < markers; ++k) {
    order[k] = k;
    std::swap(order[k], order[counterRandom(seed, k) % (k + 1)]);
  }
  std::vector<bool> covered(markers, false);
  const auto count =
      static_cast<std::size_t>(std::lround(scene.covered_share * static_cast<double>(markers)));
  for (std::size_t k = 0; k < count; ++k) covered[order[k]] = true;
  return covered;
}

}  // namespace

struct ScenePlayer::Body {
  Scene scene;
  camera::StereoRig rig;
  std::vector<Station> stations;
  std::unique_ptr<TargetCarrier> target;
  StereoRenderer renderer;

  Body(const Scene& played, camera::StereoRig stereo, std::vector<Station> stops,
       std::unique_ptr<TargetCarrier> carrier)
      : scene(played),
        rig(std::move(stereo)),
        stations(std::move(stops)),
        target(std::move(carrier)),
        renderer(rig, scene.light, scene.sensor) {}

  [[nodiscard]] const Station& stationOf(int i) const {
    return stations[static_cast<std::size_t>(scene.camera.grid ? i / scene.camera.grid->frames : 0)];
  }
  [[nodiscard]] double middleOf(int i) const { return i / scene.rate_hz + 0.5 * scene.exposure.count(); }

  [[nodiscard]] StereoRenderer::Instant patchesOf(const RigidTransform& X_CW,
                                                  const std::vector<Disc>& discs_W,
                                                  const std::vector<bool>& covered) const {
    StereoRenderer::Instant patches_C;
    for (const Patch& patch_W : scene.clutter_W) patches_C.push_back(transformed(X_CW, patch_W));
    for (std::size_t k = 0; k < discs_W.size(); ++k)
      if (!covered[k]) patches_C.push_back(transformed(X_CW, patchOf(discs_W[k])));
    return patches_C;
  }
};

FromFile<ScenePlayer> ScenePlayer::make(const Scene& scene, const std::filesystem::path& resources) {
  auto rig = camera::readRig(scene.rig);
  if (!rig) return unexpected(rig.error());
  auto stations = stationsFor(scene, resources);
  if (!stations) return unexpected(stations.error());
  const RigidTransform& X_WC = stations->front().X_WC;
  auto target =
      TargetCarrier::make(scene, {X_WC.translation(), (X_WC * rig->X_RC.inverse()).translation()}, resources);
  if (!target) return unexpected(target.error());
  return ScenePlayer(
      std::make_unique<Body>(scene, std::move(*rig), std::move(*stations), std::move(*target)));
}

ScenePlayer::ScenePlayer(std::unique_ptr<Body> body) : body_(std::move(body)) {}
ScenePlayer::~ScenePlayer() = default;
ScenePlayer::ScenePlayer(ScenePlayer&&) noexcept = default;
ScenePlayer& ScenePlayer::operator=(ScenePlayer&&) noexcept = default;

const camera::StereoRig& ScenePlayer::rig() const { return body_->rig; }
const std::vector<Disc>& ScenePlayer::discs_T() const { return body_->target->discs_T(); }

ScenePlayer::Shot ScenePlayer::shoot(int i) {
  const Scene& scene = body_->scene;
  const Station& station = body_->stationOf(i);
  const RigidTransform X_CW = station.X_WC.inverse();
  const double middle_s = body_->middleOf(i);
  const auto covered = coveredIn(scene, i, discs_T().size());
  std::array<StereoRenderer::Instant, std::size(kInstants)> instants_C;
  TargetCarrier::Moment middle;
  for (std::size_t k = 0; k < instants_C.size(); ++k) {
    auto moment = body_->target->at(middle_s + kInstants[k] * scene.exposure.count());
    instants_C[k] = body_->patchesOf(X_CW, moment.discs_W, covered);
    if (kInstants[k] == 0.0) middle = std::move(moment);
  }
  auto [left, right] =
      body_->renderer.render(instants_C, counterRandom(scene.seed, static_cast<std::uint64_t>(i)));
  Shot shot;
  shot.frame = {std::move(left), std::move(right), TimePoint(toClock(Seconds(middle_s))), scene.exposure,
                static_cast<std::uint64_t>(i)};
  shot.X_CT = X_CW * middle.X_WT;
  for (std::size_t k = 0; k < covered.size(); ++k)
    if (!covered[k] && body_->renderer.bothSee(transformed(X_CW, patchOf(middle.discs_W[k])))) ++shot.visible;
  shot.robot = station.robot ? station.robot : middle.robot;
  return shot;
}

}  // namespace mirrorarm::simulation
