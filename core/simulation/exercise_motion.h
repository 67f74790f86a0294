#pragma once

#include <vector>

#include "core/simulation/arm_motion.h"
#include "core/simulation/bench.h"

namespace mirrorarm::simulation {

/// Frame A of a forearm: origin in its middle, x from the elbow to the wrist, z to where the cameras stand at
/// the start.
inline constexpr double kForearmLength_m = 0.25;

/// The ten discs of the sleeve in frame A: flat on a half cylinder of 45 mm radius and 220 mm length, turned
/// at most 50 degrees away from z, at places that no rigid motion maps onto each other.
[[nodiscard]] const std::vector<Disc>& sleeveDiscs();

/// A rigid forearm that repeats minimum-jerk legs; it rests without any. A positive turn is a right arm's
/// pronation: about the axis from the wrist to the elbow.
class ExerciseMotion final : public ArmMotion {
 public:
  /// `X_BA` at the start, `legs` in base B. Durations > 0, rests >= 0.
  ExerciseMotion(const RigidTransform& X_BA, std::vector<MinimumJerkLeg> legs);

  [[nodiscard]] int discCount() const override;
  void discsAt(double phase_s, std::span<Disc> discs) const override;
  [[nodiscard]] Forearm forearmAt(double phase_s) const override;

  /// Pose of the forearm.
  [[nodiscard]] RigidTransform poseAt(double phase_s) const;

 private:
  RigidTransform X_BA_;
  std::vector<MinimumJerkLeg> legs_;
  double period_s_ = 0.0;
};

}  // namespace mirrorarm::simulation
