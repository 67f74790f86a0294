#pragma once

#include "core/common/time.h"
#include "core/geometry/rigid_transform.h"

namespace mirrorarm::tracking {

/// Where a target will be: its last measured pose carried on at the velocity of the last two. One thread.
class PoseTrend {
 public:
  /// A new measured pose. One that is not later than the last replaces it without a velocity.
  void add(TimePoint time, const RigidTransform& X_CT);
  void forget() { *this = {}; }

  [[nodiscard]] bool isKnown() const { return known_; }
  /// Since the last measured pose; never negative.
  [[nodiscard]] Seconds ageAt(TimePoint time) const;
  /// Pose at `time`; the last one itself for times before it.
  [[nodiscard]] RigidTransform at(TimePoint time) const;
  /// How far a marker may be from where at() puts it [m]: what an arm's acceleration, or without a velocity
  /// its speed, makes of the age.
  [[nodiscard]] double uncertaintyAt(TimePoint time) const;

 private:
  bool known_ = false;
  bool moving_ = false;  ///< a velocity is known
  TimePoint time_{};
  RigidTransform X_CT_ = RigidTransform::Identity();
  Eigen::Vector3d velocity_C_ = Eigen::Vector3d::Zero();   ///< of T's origin [m/s]
  Eigen::Vector3d turn_rate_C_ = Eigen::Vector3d::Zero();  ///< [rad/s]
};

}  // namespace mirrorarm::tracking
