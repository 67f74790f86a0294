#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "core/common/expected.h"
#include "core/therapy/session_measures.h"

namespace mirrorarm::cli {

/// poses.csv of a session: a row a frame, target in the left camera.
[[nodiscard]] Expected<void, std::string> writePoses(const std::filesystem::path& file,
                                                     std::span<const therapy::Sample> samples);

/// robot.csv of a session: joints and flange in base at each frame's exposure; `X_FE` is the end effector's
/// pose in the flange.
[[nodiscard]] Expected<void, std::string> writeRobot(const std::filesystem::path& file,
                                                     std::span<const therapy::Sample> samples,
                                                     const RigidTransform& X_FE);

}  // namespace mirrorarm::cli
