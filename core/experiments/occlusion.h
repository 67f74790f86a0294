#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/common/expected.h"
#include "core/experiments/pose_statistics.h"

namespace mirrorarm::experiments {

/// The paper's cuboid with a share of the markers covered, others in each frame.
struct OcclusionRow {
  double covered_share = 0.0;
  PoseStatistics ours;
  PoseStatistics paper;  ///< the paper's whole method on the same images
};

/// Section 3.2: the robot carries the cameras over a cuboid of 60 x 60 x 40 mm in steps of 20 mm above a
/// target of ten markers on a table, taught once with all markers seen; then up to half of them are covered.
/// One row a share, 0 to 50 % in steps of 10. Takes about a minute. The error says which resource cannot be
/// read.
[[nodiscard]] Expected<std::vector<OcclusionRow>, std::string> measureOcclusion(
    const std::filesystem::path& resources);

}  // namespace mirrorarm::experiments
