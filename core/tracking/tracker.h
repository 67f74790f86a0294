#pragma once

#include <memory>
#include <span>

#include "core/common/time.h"
#include "core/tracking/softassign.h"
#include "core/tracking/target.h"
#include "core/tracking/tracked_target.h"
#include "core/vision/stereo_observation.h"

namespace mirrorarm::tracking {

struct TrackerSettings {
  SoftassignSettings softassign;
  bool full_schedule = false;     ///< anneal every frame from softassign.beta_start to its end, as the paper
                                  ///< does; else from a beta that suits how well the pose is known already
  double min_marker_share = 0.5;  ///< matched markers that a fit needs (paper: 50 %)
  double max_rms_m = 0.003;       ///< of an accepted fit (paper: 3 mm)
  Seconds predict_for{0.1};       ///< how long a target that vanished is carried on at its velocity
  Seconds follow_for{0.25};  ///< how old the last pose may be to start from; then the target is sought anew
  int rejections_before_reteach = 4;  ///< rejected frames in a row after which the model no longer fits
};

/// Follows several taught targets from frame to frame. Each starts from its last pose, carried on at its
/// velocity, while that is fresh, and looks only at points near its predicted markers; a target without one
/// is sought in any orientation. A fit is accepted with min_marker_share of the markers, at least 3 (a first
/// one: at least 4, or all that the target has), and max_rms_m. Pairs are one-to-one, also in the discs that
/// the points were measured from; points of one target, and their rivals, are not given to the next: fresh
/// targets choose first, then the others in their order. Points that are not finite are ignored. At most
/// kMaxPoints points are considered for one target, in their given order (those near the prediction, or the
/// free ones when it is sought), and no point past the first 32768: time is bounded whatever a cloud holds.
/// Following takes nothing from the heap once its buffers have grown. One thread (the tracking thread).
class Tracker {
 public:
  explicit Tracker(const TrackerSettings& settings);
  ~Tracker();
  Tracker(Tracker&&) noexcept;
  Tracker& operator=(Tracker&&) noexcept;

  /// Replaces all targets and forgets their poses. A target has at most kMaxMarkers markers; one with fewer
  /// than 3 or with markers on a line is answered as lost.
  void setTargets(std::span<const Target> targets);
  /// Replaces the model of one target and keeps its pose: re-teaching in a running session.
  void replaceTarget(std::size_t index, const Target& target);
  [[nodiscard]] std::span<const Target> targets() const;

  /// One answer a target, in the order of the targets; the span stays good until the next call.
  [[nodiscard]] std::span<const TrackedTarget> track(std::span<const vision::StereoPoint> points,
                                                     TimePoint exposed_at);

  /// True when target `index` was rejected so often in a row that its model should be taught anew: frames
  /// that held enough points for a fit but gave none. Frames with too few points say nothing about the model.
  [[nodiscard]] bool needsReteaching(std::size_t index) const;

 private:
  struct Body;
  std::unique_ptr<Body> body_;
};

}  // namespace mirrorarm::tracking
