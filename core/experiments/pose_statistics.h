#pragma once

#include <span>

#include <Eigen/Core>

#include "core/experiments/scene_trial.h"

namespace mirrorarm::experiments {

/// How well the tracked frames of a trial agree with the truth.
struct PoseStatistics {
  int frames = 0;
  int tracked = 0;
  double fit_rms_mm = 0.0;                           ///< mean of the frames' own misfits
  double rms_mm = 0.0;                               ///< of the target's origin against truth
  double turn_rms_deg = 0.0;                         ///< of its orientation
  Eigen::Vector3d std_mm = Eigen::Vector3d::Zero();  ///< of the origin's error along the left camera's axes
  [[nodiscard]] double trackedShare() const { return static_cast<double>(tracked) / frames; }
};

/// The taught frame and the scene's differ by a motion that is the same in all frames: it is the one that
/// makes the errors smallest. Not a number where nothing was tracked.
[[nodiscard]] PoseStatistics statisticsOf(std::span<const TrialFrame> frames);

}  // namespace mirrorarm::experiments
