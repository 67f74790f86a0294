#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "core/camera/stereo_rig.h"
#include "core/common/time.h"
#include "core/tracking/constellation_search.h"
#include "core/tracking/paper_registration.h"
#include "core/tracking/skin_model.h"
#include "core/tracking/target.h"
#include "core/tracking/tracked_target.h"
#include "core/tracking/warm_registration.h"
#include "core/vision/stereo_observation.h"

namespace mirrorarm::tracking {

/// How targets are found and followed.
enum class TrackingMethod : std::uint8_t {
  kCliques,     ///< from nothing by cliques, then by prediction, softassign and the pose of greatest
                ///< likelihood, on a shape that follows the skin
  kSoftassign,  ///< the paper's alone, for comparison
};
/// "cliques", "softassign".
[[nodiscard]] std::string_view id(TrackingMethod method);
[[nodiscard]] std::optional<TrackingMethod> trackingMethodOf(std::string_view id);

struct TrackerSettings {
  TrackingMethod method = TrackingMethod::kCliques;
  WarmSettings warm;
  ConstellationSettings search;
  SkinSettings skin;
  PaperSettings paper;       ///< for kSoftassign alone
  Seconds predict_for{0.1};  ///< how long a target that vanished is carried on
  Seconds follow_for{0.25};  ///< how old the last pose may be to start from; then the target is sought anew
};

/// Follows several taught targets from frame to frame. Each is looked for where its motion leads it, while
/// its last pose is fresh: every marker inside the gate that prediction, skin and sensor make together, 3 of
/// them suffice. A target without a fresh pose, or not found there, is sought in any orientation among the
/// points that are left, where 5 markers prove it, 4 when nothing else fits and few points are about. What is
/// ambiguous is told, not guessed. Every pose is that of greatest likelihood with its covariance. Pairs are
/// one-to-one, also in the discs that the points were measured from; points of one target are not given to
/// the next: fresh targets choose first, then the others, the surest first.
///
/// Points that are not finite are ignored. At most kMaxPoints are considered for one target (those near where
/// it is expected, or the free ones when it is sought), in their given order: time is bounded whatever a
/// cloud holds. Nothing is taken from the heap once the buffers have grown, but when a shape is taught anew.
/// One thread (the tracking thread).
class Tracker {
 public:
  explicit Tracker(const TrackerSettings& settings);
  ~Tracker();
  Tracker(Tracker&&) noexcept;
  Tracker& operator=(Tracker&&) noexcept;

  /// The cameras that the points come from, so that a target that leaves their view is told as such. Without
  /// them everything is in view.
  void setRig(const camera::StereoRig& rig);

  /// Replaces all targets and forgets their poses. A target has at most kMaxMarkers markers; one with fewer
  /// than 3 or with markers on a line is answered as lost.
  void setTargets(std::span<const Target> targets);
  [[nodiscard]] std::size_t size() const;
  /// A target as it is now: taught, and adapted since by the skin that carries it.
  [[nodiscard]] const Target& target(std::size_t index) const;
  /// Rises when target(index) was taught anew while it was followed: by a slip, an added marker, or in the
  /// paper's way after several rejections.
  [[nodiscard]] int version(std::size_t index) const;
  /// What the last frame that was learnt from showed of the target's skin.
  [[nodiscard]] SkinEvent event(std::size_t index) const;

  /// One answer a target, in the order of the targets; the span stays good until the next call. Frames come
  /// in the order of their exposure.
  [[nodiscard]] std::span<const TrackedTarget> track(std::span<const vision::StereoPoint> points,
                                                     TimePoint exposed_at);

  /// Learns from the frame just tracked how the skin moved. Apart from track(), so that the robot has the
  /// pose first; called by the next track() when nobody did. event(), version() and target() speak of what
  /// was learnt.
  void learn();

  /// Where a target is at any time: carried on from its last measured poses; kStale when those are too old.
  [[nodiscard]] TrackedTarget at(std::size_t index, TimePoint time) const;

 private:
  struct Body;
  std::unique_ptr<Body> body_;
};

}  // namespace mirrorarm::tracking
