#pragma once

#include <filesystem>
#include <string>

#include "core/common/expected.h"
#include "core/experiments/scene_trial.h"

namespace mirrorarm::experiments {

/// How long something took over many frames.
struct DurationStatistics {
  double median_ms = 0.0, mean_ms = 0.0, std_ms = 0.0, p99_ms = 0.0;
};

/// Of one approach: both images to points, points to pose and covariance, and all together.
struct ChainTiming {
  DurationStatistics vision, tracking, whole;
  double tracked_share = 0.0;
};

struct TimingResult {
  int markers = 0;
  int frames = 0;
  ChainTiming ours;
  ChainTiming paper;  ///< the paper's whole method on the same images
};

/// Section 3.2: computing time with ten markers on a moving forearm, images of 1296 x 964, on this machine.
/// The images are made beforehand; the first second of each run is not counted.
[[nodiscard]] Expected<TimingResult, std::string> measureTiming(const std::filesystem::path& resources);

}  // namespace mirrorarm::experiments
