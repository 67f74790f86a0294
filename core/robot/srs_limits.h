#pragma once

#include <array>
#include <span>

#include "core/robot/joint_ranges.h"
#include "core/robot/srs_postures.h"

namespace mirrorarm::robot {

/// Arm angles from `from` to `to` >= `from` [rad]; a full circle when they are 2 pi apart.
struct ArmAngleRange {
  double from = 0.0;
  double to = 0.0;
  unsigned branches = 0;  ///< bit b: branch b keeps the ranges of all joints
};

/// The circle of arm angles of one pose, cut wherever a joint of some branch comes to the end of its range.
/// Between two cuts each branch keeps its ranges or does not, as a whole. Never on the heap.
/// Source: Shimizu et al., T-RO 24 (2008), section IV.
class ArmAngleRanges {
 public:
  ArmAngleRanges(const SrsArm& arm, const SrsPostures& postures, const JointRanges& ranges);
  /// Those that at least one branch may use.
  [[nodiscard]] std::span<const ArmAngleRange> usable() const { return {usable_.data(), count_}; }

 private:
  static constexpr std::size_t kMost = 24;  // six turning joints, two ends, two arm angles each
  std::array<ArmAngleRange, kMost> usable_{};
  std::size_t count_ = 0;
};

}  // namespace mirrorarm::robot
