#pragma once

#include <span>
#include <vector>

#include "core/tracking/bundle_adjustment.h"
#include "core/tracking/keyframes.h"
#include "core/tracking/running_model.h"

namespace mirrorarm::tracking {

/// The network of chosen points in the frames of a lesson.
struct LessonNetwork {
  MarkerNetwork network;              ///< markers in the order of the points
  std::vector<std::size_t> keyframe;  ///< of each frame of the network
};

/// Frames that show fewer than 3 of the points are left out, and frames at even steps when there are so many
/// markers that all would take too long.
[[nodiscard]] LessonNetwork networkOf(std::span<const RunningModel::Point> points,
                                      std::span<const NetworkFrame> keyframes);

/// How far each marker moves against the others, standard deviation per axis [m]: its spread where the
/// sensor's covariance is known, else what its spread exceeds that of the quiet markers by; 0 where chance
/// explains that.
[[nodiscard]] std::vector<double> skinSigmas(const MarkerNetwork& adjusted);

/// Largest standard deviation of a marker, in its least sure direction [m].
[[nodiscard]] double largestSigma(const BundleAdjustment& adjustment, std::size_t markers);

}  // namespace mirrorarm::tracking
