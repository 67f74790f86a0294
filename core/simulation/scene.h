#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/common/file_error.h"
#include "core/common/time.h"
#include "core/simulation/bench.h"
#include "core/simulation/patch.h"
#include "core/simulation/sensor.h"
#include "core/simulation/stereo_renderer.h"

namespace mirrorarm::simulation {

/// Who moves the target of a scene.
enum class Carrier { kTable, kForearm, kUr5 };
/// "table", "forearm", "ur5".
[[nodiscard]] std::string_view id(Carrier carrier);
[[nodiscard]] std::optional<Carrier> carrierOf(std::string_view id);

/// What a stereo recording is simulated from; docs/scene-format.md is the manual of its file. Frames: W
/// world, T target (origin at the centroid of its markers), C left camera.
struct Scene {
  /// Camera stations on a cuboid around the first pose, a layer after the other, to and fro.
  struct Grid {
    Eigen::Vector3d size_m = Eigen::Vector3d::Zero();  ///< along the axes of W
    double step_m = 0.02;
    int frames = 1;  ///< at each station
  };
  struct Camera {
    bool on_robot = false;  ///< the LBR 4+ of the bench carries it: W is the robot's base
    RigidTransform X_WC = RigidTransform::Identity();  ///< at the start
    std::optional<Grid> grid;
  };
  struct Target {
    std::string name = "target";
    double marker_diameter_m = 0.007;
    std::vector<Disc> discs_T;  ///< empty for a recorded motion, which brings its own
    Carrier carried_by = Carrier::kTable;
    RigidTransform X_WT = RigidTransform::Identity();  ///< at the start
    std::vector<MinimumJerkLeg> legs;                  ///< forearm or UR5
    std::filesystem::path motion;                      ///< forearm: a TRC file in place of legs
    RigidTransform X_WU = RigidTransform::Identity();  ///< base of the UR5
    RigidTransform X_FT = RigidTransform::Identity();  ///< target on its flange
    std::vector<double> posture_rad;                   ///< of the UR5, near the start pose
  };

  std::filesystem::path file;  ///< where the scene was read from
  std::filesystem::path rig;
  std::uint64_t seed = 1;
  int frames = 0;
  double rate_hz = 24.0;
  Seconds exposure{0.0015};
  LightSettings light;
  SensorSettings sensor;
  Camera camera;
  Target target;
  std::vector<Patch> clutter_W;
  double covered_share = 0.0;  ///< of the markers, others in each frame
};

/// Reads a scene (format mirrorarm/scene/1). `resources` holds the rigs called by name. Refused with the line
/// and key: what is unknown, missing, out of its range or does not go together.
[[nodiscard]] FromFile<Scene> readScene(const std::filesystem::path& file,
                                        const std::filesystem::path& resources);

/// Stations of a grid as displacements from its middle [m].
[[nodiscard]] std::vector<Eigen::Vector3d> stationsOf(const Scene::Grid& grid);

}  // namespace mirrorarm::simulation
