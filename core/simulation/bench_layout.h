#pragma once

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "core/camera/camera_model.h"
#include "core/common/file_error.h"
#include "core/robot/arm_description.h"
#include "core/robot/hand.h"
#include "core/robot/kinematics.h"
#include "core/robot/obstacle.h"
#include "core/simulation/patch.h"

/// Where everything stands on the simulated bench. Robot base B: x from the robot's foot towards the patient,
/// z up. The patient sits opposite, right arm on the side of +y (healthy), left arm in the sling below the
/// flange.
namespace mirrorarm::simulation::bench_layout {

/// Flange at the start: 0.55 m before the foot, 0.45 m high, pointing down; x_F against x_B, y_F along y_B.
[[nodiscard]] RigidTransform startX_BF();
/// Angles of the LBR 4+ that bring the flange there with a bent elbow, far from limits and stretched poses.
[[nodiscard]] std::optional<robot::Joints> startPosture(const robot::Kinematics& kinematics);

/// Left camera at the start: beside the flange towards the healthy arm, looking along +y_B, 15 degrees down.
/// The bench's hand carries it there.
[[nodiscard]] RigidTransform startX_BC();
/// robots/lbr4plus.urdf: the arm of the bench.
[[nodiscard]] FromFile<robot::ArmDescription> arm(const std::filesystem::path& resources);
/// robots/hand.yaml: camera bar and sling of the bench.
[[nodiscard]] FromFile<robot::Hand> hand(const std::filesystem::path& resources);
/// robots/surroundings.yaml: table and patient's head.
[[nodiscard]] FromFile<std::vector<robot::Obstacle>> surroundings(const std::filesystem::path& resources);
/// Healthy forearm at the start, in the left camera: 0.40 m in front of the middle between both cameras,
/// lying across the image, elbow towards the patient (see exercise_motion.h for frame A).
[[nodiscard]] RigidTransform startX_CA();

/// Calibration plate P before the cameras at the start, facing them: origin in its middle, x across the
/// images, y downwards, z away from the cameras. On a stand there, the arm reaches three fifths of the views
/// from 0.28 to 0.6 m with tilts to 40 degrees, some in every direction.
[[nodiscard]] RigidTransform plateX_BP();

/// What else shines: a strip of tape on a chair, two dim blotches behind the patient. In B.
[[nodiscard]] std::vector<Patch> clutter();

/// The impaired forearm's wrist hangs in the sling at `sling_B`; its elbow trails towards the body.
[[nodiscard]] ArmMotion::Forearm impairedForearm(const Eigen::Vector3d& sling_B);

/// rigs/fisheye.yaml or rigs/pinhole.yaml.
[[nodiscard]] std::filesystem::path rigFile(const std::filesystem::path& resources, camera::LensModel lens);

}  // namespace mirrorarm::simulation::bench_layout
