#pragma once

#include <memory>
#include <optional>
#include <span>

#include <Eigen/Core>

#include "core/common/time.h"
#include "core/geometry/rigid_transform.h"
#include "core/tracking/cloud_point.h"
#include "core/tracking/skin_event.h"
#include "core/tracking/target.h"

namespace mirrorarm::tracking {

struct SkinSettings {
  Seconds learning_time{5.0};     ///< over which deviations are learnt and forgotten
  Seconds adaptation_time{20.0};  ///< over which the rest shape follows a lasting change
  double slip_sigmas = 6.0;       ///< a jump beyond so many sigmas of what was learnt is a slip
  Seconds slip_time{0.2};         ///< if it lasts so long
  Seconds missing_time{3.0};      ///< a marker in view and not found for so long has fallen off
  Seconds adding_time{1.0};       ///< a stranger that moves with the body for so long is a marker of it
};

/// One frame as the model learns from it.
struct SkinObservation {
  TimePoint time{};
  RigidTransform X_CT = RigidTransform::Identity();  ///< the accepted pose, fitted to shape_T()
  std::span<const CloudPoint> cloud;                 ///< every finite point of the frame
  std::span<const int> point_of_marker;              ///< a point of the cloud for each marker, -1 for none
  std::span<const char> taken;    ///< a flag for each point: some target's, or a rival of one
  std::span<const char> in_view;  ///< a flag for each marker: both cameras could see it
};

/// The shape of one target whose markers move against each other on skin: where each is expected next and how
/// sure that is. A marker's deviation from the rest shape is the sum of a few modes in which the markers move
/// together, learnt as principal components, and a part of its own; both are carried from frame to frame, so
/// identities hold through large slow deformations, and hidden markers follow the seen ones by the modes. A
/// rigid body comes out as one: its deviations are learnt to be nothing. Deviations never hold a rigid motion
/// (weighted by stiffness), so frame T stays where it was taught: on the stiffest part of the body.
/// One thread; nothing is taken from the heap in observe() except when a marker is added.
class SkinModel {
 public:
  SkinModel(const Target& taught, const SkinSettings& settings);
  ~SkinModel();
  SkinModel(SkinModel&&) noexcept;
  SkinModel& operator=(SkinModel&&) noexcept;

  /// Carries the deviation on to the time of a new frame.
  void predict(TimePoint time);
  /// Learns from a frame with an accepted pose, all since predict().
  SkinEvent observe(const SkinObservation& seen);
  /// A frame near the last known pose that the shape does not fit any more, with enough points for it:
  /// matches are looked for as wide as skin moves. When they are found shape_T() goes where they are at once
  /// and foundPose() tells from where the fit may be tried again in the same frame; when they last the shape
  /// is taught anew (kSlipped). `X_CT` is the predicted pose; `point_of_marker` is not read.
  SkinEvent observeMisfit(const SkinObservation& seen);
  /// The pose at which the last observeMisfit() found the markers; nothing when it did not.
  [[nodiscard]] const std::optional<RigidTransform>& foundPose() const;

  /// Where each marker is expected now, in T [m], and how sure that is: taught precision and deviation.
  [[nodiscard]] std::span<const Eigen::Vector3d> shape_T() const;
  [[nodiscard]] std::span<const Eigen::Matrix3d> covariance_m2() const;
  /// A flag for each marker: it counts, it has not fallen off.
  [[nodiscard]] std::span<const char> present() const;
  /// How far the shape is from its rest now, root mean square over the markers [m].
  [[nodiscard]] double deviation_m() const;
  /// How far two markers' distance may be from the rest shape's [m]: what a search from nothing must allow.
  [[nodiscard]] double tolerance_m() const;

  /// The target as it is now: rest shape with its covariance, added markers at the end; fallen ones stay in.
  [[nodiscard]] const Target& target() const;
  /// Rises whenever target() gets another shape by a slip or an added marker.
  [[nodiscard]] int version() const;

 private:
  struct Body;
  std::unique_ptr<Body> body_;
};

}  // namespace mirrorarm::tracking
