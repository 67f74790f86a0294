#pragma once

#include <cstdint>
#include <string_view>

#include "core/common/expected.h"
#include "core/robot/srs_limits.h"

namespace mirrorarm::robot {

/// Why no posture was chosen.
enum class NoPosture : std::uint8_t {
  kOutOfReach,
  kOutsideLimits,  ///< in reach, but not within the joints' ranges
  kOnlyWithJump,   ///< within the ranges, but not near the seed
};
/// "out_of_reach", "outside_limits", "only_with_jump"
[[nodiscard]] std::string_view id(NoPosture reason);

/// Chooses among the postures of a redundant S-R-S arm. The same question gets the same answer. Never on the
/// heap; may be shared between threads.
class PostureChoice {
 public:
  PostureChoice(const SrsArm& arm, const JointRanges& ranges) : arm_(arm), ranges_(ranges) {}

  /// The posture that continues `seed`: its branch, and its arm angle drawn a little towards where the joints
  /// are far from the ends of their ranges and the shoulder and wrist are bent. The draw is bounded by how
  /// far the wrist moves, so that neighbouring poses get neighbouring postures and a closed movement ends in
  /// the posture in which it began. Where the arm angle would leave the ranges it stays at their end.
  [[nodiscard]] Expected<Joints, NoPosture> nearest(const RigidTransform& X_BF, const Joints& seed) const;

  /// A posture within the ranges wherever there is one: on each branch the arm angle next to the seed's, of
  /// these the one that turns its joints least. For a pose that is travelled to, not followed.
  [[nodiscard]] Expected<Joints, NoPosture> any(const RigidTransform& X_BF, const Joints& seed) const;

 private:
  SrsArm arm_;
  JointRanges ranges_;
};

}  // namespace mirrorarm::robot
