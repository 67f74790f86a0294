#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "core/common/expected.h"
#include "core/tracking/tracked_target.h"

namespace mirrorarm::tracking {

/// One target in one frame, as poses.csv and matches.csv tell it.
struct PoseRow {
  long long index = 0;  ///< of the frame
  std::string target;
  TrackedTarget answer;
  std::vector<Eigen::Vector3d> points_C;  ///< the point of each matched marker, in the markers' order [m]
};

/// Writes poses.csv, a row for each, numbers empty when lost; whole or not at all. sigma_t_m and sigma_r_rad
/// are the largest standard deviations of shift and turn.
[[nodiscard]] Expected<void, std::string> writePoses(const std::filesystem::path& file,
                                                     std::span<const PoseRow> rows);

/// Writes matches.csv: which measured point was taken for which marker.
[[nodiscard]] Expected<void, std::string> writeMatches(const std::filesystem::path& file,
                                                       std::span<const PoseRow> rows);

}  // namespace mirrorarm::tracking
