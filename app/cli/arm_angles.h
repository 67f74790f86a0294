#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include <CLI/App.hpp>

#include "app/cli/command.h"
#include "core/tracking/arm_joints.h"
#include "core/tracking/pose_file.h"
#include "core/tracking/target.h"

namespace mirrorarm::cli {

/// Where the arm's bones are read from and its joint angles written to; both or neither are given.
struct AngleOptions {
  std::filesystem::path arm;
  std::filesystem::path angles;
};
void addAngleOptions(CLI::App& command, AngleOptions& options);

/// The arm asked for, before any work is done. Refused: a file that is none, targets of it that are not
/// tracked.
[[nodiscard]] std::optional<tracking::ArmModel> armAskedFor(const AngleOptions& options,
                                                            const std::vector<tracking::Target>& targets);

/// Writes the angles and gives the keys of `--json`: ranges of the joints in degrees.
[[nodiscard]] nlohmann::ordered_json writeArmAngles(const std::filesystem::path& file,
                                                    const tracking::ArmModel& arm,
                                                    std::span<const tracking::PoseRow> poses);

}  // namespace mirrorarm::cli
