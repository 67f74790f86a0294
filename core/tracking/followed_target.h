#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/camera/stereo_rig.h"
#include "core/tracking/frame_cloud.h"
#include "core/tracking/motion_predictor.h"
#include "core/tracking/shape.h"
#include "core/tracking/shape_fit.h"
#include "core/tracking/skin_model.h"

namespace mirrorarm::tracking {

/// What is kept of one target from frame to frame.
class FollowedTarget {
 public:
  FollowedTarget(const Target& taught, const SkinSettings& settings);

  /// A new frame: nothing is matched yet, the skin moves on.
  void begin(TimePoint time);
  [[nodiscard]] Shape shape() const;
  /// Where the markers are when the target is at `X_CT`; good until the next call.
  [[nodiscard]] std::span<const Eigen::Vector3d> placesAt(const RigidTransform& X_CT);
  [[nodiscard]] bool isFresh(TimePoint time, Seconds for_how_long) const;

  /// An accepted fit; `cloud` is the one whose last selection it was made on, whose points it takes.
  void accept(const ShapeFit& fit, TimePoint time, FrameCloud& cloud);
  [[nodiscard]] std::span<const int> pointOfMarker() const { return point_of_marker_; }

  /// Learns from a frame with an accepted pose, after all targets have taken their points.
  void learn(TimePoint time, const FrameCloud& cloud, const std::optional<camera::StereoRig>& rig);
  /// Learns from one whose points do not fit where the target is expected; true when the shape goes with them
  /// now, and a fit from the expected pose, which moved with it, may succeed.
  bool learnFromMisfit(TimePoint time, const FrameCloud& cloud, const std::optional<camera::StereoRig>& rig);
  /// Another model of the same body in the same frame.
  void replaceShape(const Target& target);

  /// Fewer than three of its markers can be seen by both cameras where it should be.
  [[nodiscard]] bool isOutOfView(TimePoint time, const camera::StereoRig& rig);

  [[nodiscard]] const MotionPredictor& motion() const { return motion_; }
  /// The last accepted pose; good while motion() is known.
  [[nodiscard]] const RigidTransform& lastPose() const { return last_X_CT_; }
  [[nodiscard]] const SkinModel& skin() const { return skin_; }
  [[nodiscard]] SkinEvent event() const { return event_; }
  [[nodiscard]] int version() const { return replaced_ + skin_.version(); }

 private:
  [[nodiscard]] SkinObservation observation(TimePoint time, const RigidTransform& X_CT,
                                            const FrameCloud& cloud,
                                            const std::optional<camera::StereoRig>& rig);

  SkinSettings settings_;
  SkinModel skin_;
  MotionPredictor motion_;
  RigidTransform last_X_CT_ = RigidTransform::Identity();
  SkinEvent event_ = SkinEvent::kNone;
  int replaced_ = 0;
  std::vector<int> point_of_marker_;  ///< in the frame's cloud
  std::vector<Eigen::Vector3d> places_C_;
  std::vector<char> in_view_;
};

}  // namespace mirrorarm::tracking
