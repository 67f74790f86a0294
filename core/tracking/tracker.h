#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/tracking/softassign.h"
#include "core/tracking/target.h"
#include "core/tracking/tracked_target.h"
#include "core/vision/stereo_observation.h"

namespace mirrorarm::tracking {

struct TrackerSettings {
  SoftassignSettings softassign;
  double min_marker_share = 0.5;   ///< matched markers that a fit needs (paper: 50 %)
  double max_rms_m = 0.003;        ///< of an accepted fit (paper: 3 mm)
  int rejections_before_reteach = 12;  ///< rejected frames in a row after which the model no longer fits
};

/// Follows several taught targets from frame to frame. Each starts from its last pose while that is fresh; a
/// target without one is sought from many first orientations.
/// One thread (the tracking thread).
class Tracker {
 public:
  explicit Tracker(const TrackerSettings& settings);
  ~Tracker();

  /// Replaces all targets and forgets their poses.
  void setTargets(std::span<const Target> targets);
  /// Replaces the model of one target and keeps its pose: re-teaching in a running session.
  void replaceTarget(std::size_t index, const Target& target);
  [[nodiscard]] std::span<const Target> targets() const;

  /// One answer a target, in the order of the targets; the span stays good until the next call.
  [[nodiscard]] std::span<const TrackedTarget> track(std::span<const vision::StereoPoint> points,
                                                     TimePoint exposed_at);

  /// True when target `index` was rejected so often in a row that its model should be taught anew.
  [[nodiscard]] bool needsReteaching(std::size_t index) const;

 private:
  struct Body;
  std::unique_ptr<Body> body_;
};

}  // namespace mirrorarm::tracking
