#include "core/experiments/accuracy.h"

#include <cmath>

#include "core/experiments/encoder_noise.h"
#include "core/experiments/scene_trial.h"
#include "core/geometry/rigid_fit.h"
#include "core/robot/kinematics.h"
#include "core/robot/urdf.h"

namespace mirrorarm::experiments {
namespace {

/// The cuboid's images, and where the flange was at each: by the encoders, and truly.
struct Cuboid {
  PlayedScene played;
  std::vector<RigidTransform> read_X_BF;

  [[nodiscard]] std::vector<Eigen::Vector3d> middles_C() const {
    const Eigen::Vector3d middle_T = centroid(played.markers_T);
    std::vector<Eigen::Vector3d> points;
    for (const auto& shot : played.shots) points.push_back(shot.X_CT * middle_T);
    return points;
  }
};

Expected<Cuboid, std::string> playCuboid(const std::filesystem::path& resources, std::uint64_t seed) {
  auto scene = simulation::readScene(resources / "scenes/paper_cuboid.yaml", resources);
  if (!scene) return unexpected(describe(scene.error()));
  scene->seed = seed;
  auto played = play(*scene, resources);
  if (!played) return unexpected(describe(played.error()));
  const auto arm = robot::readUrdf(resources / "robots/lbr4plus.urdf");
  if (!arm) return unexpected(describe(arm.error()));
  const robot::Kinematics kinematics(*arm);
  Cuboid cuboid{std::move(*played), {}};
  for (const auto& shot : cuboid.played.shots)
    cuboid.read_X_BF.push_back(kinematics.flange(asRead(shot.robot->q_rad, seed, shot.frame.sequence)));
  return cuboid;
}

struct Tracked {
  std::vector<AccuracyStation> stations;
  double fit_rms_mm = 0.0;
};

/// Teaches and tracks by `rig` and `X_FC`. The markers' middle is the same point of the object whatever frame
/// the lesson gave it.
Expected<Tracked, std::string> track(const Cuboid& cuboid, const camera::StereoRig& rig,
                                     const RigidTransform& X_FC, const RigidTransform& true_X_FC) {
  PlayedScene seen = cuboid.played;
  seen.rig = rig;
  const auto target = teachFrom(seen, Approach{}.centres);
  if (!target) return unexpected(std::string("the target could not be taught"));
  const Eigen::Vector3d middle_T = centroid(target->markers_T);
  const auto middles_C = cuboid.middles_C();
  const auto frames = track(seen, *target, {}, true);
  Tracked result;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (frames[i].answer.status != tracking::TrackStatus::kTracked) continue;
    result.stations.push_back({cuboid.read_X_BF[i] * X_FC * frames[i].answer.X_CT * middle_T,
                               seen.shots[i].robot->X_BF * true_X_FC * middles_C[i]});
    result.fit_rms_mm += 1e3 * frames[i].answer.rms_m;
  }
  if (result.stations.empty()) return unexpected(std::string("the target was never tracked"));
  result.fit_rms_mm /= static_cast<double>(result.stations.size());
  return result;
}

}  // namespace

AccuracyStatistics statisticsOf(std::span<const AccuracyStation> stations) {
  const auto count = static_cast<double>(stations.size());
  AccuracyStatistics result;
  Eigen::Vector3d squares = Eigen::Vector3d::Zero();
  for (const auto& station : stations) {
    const Eigen::Vector3d error_mm = 1e3 * (station.measured_B - station.true_B);
    result.bias_mm += error_mm / count;
    squares += error_mm.cwiseAbs2() / count;
  }
  result.std_mm = (squares - result.bias_mm.cwiseAbs2()).cwiseMax(0.0).cwiseSqrt();
  result.rms_mm = std::sqrt(squares.sum());
  return result;
}

Expected<AccuracyResult, std::string> measureAccuracy(const std::filesystem::path& resources,
                                                      std::uint64_t seed) {
  auto calibration = calibrateInSimulation(resources, {.seed = seed});
  if (!calibration) return unexpected(calibration.error());
  const auto cuboid = playCuboid(resources, seed);
  if (!cuboid) return unexpected(cuboid.error());
  const auto& [rig, true_X_FC, hand_eye] = *calibration;
  const auto chain = track(*cuboid, rig.stereo.rig, hand_eye.X_PC, true_X_FC);
  const auto given = track(*cuboid, rig.true_rig, true_X_FC, true_X_FC);
  if (!chain || !given) return unexpected(chain ? given.error() : chain.error());
  AccuracyResult result;
  result.rig_bias = biasOf(rig.stereo.rig, rig.true_rig, cuboid->middles_C());
  result.chain = statisticsOf(chain->stations);
  result.given = statisticsOf(given->stations);
  result.fit_rms_mm = chain->fit_rms_mm;
  result.frames = static_cast<int>(cuboid->played.shots.size());
  result.tracked = static_cast<int>(chain->stations.size());
  result.calibration = std::move(*calibration);
  return result;
}

}  // namespace mirrorarm::experiments
