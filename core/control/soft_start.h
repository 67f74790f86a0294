#pragma once

#include "core/common/time.h"
#include "core/robot/motion_guard.h"
#include "core/robot/motion_limits.h"

namespace mirrorarm::control {

/// Lets the speed limits grow evenly from the speed that the robot has to their full size, so that no start
/// and no resumption is sudden, whatever motion is wished. One thread; does not allocate.
class SoftStart {
 public:
  explicit SoftStart(Seconds duration) : duration_(duration) {}

  /// Begins anew from what was sent last; its own speed stays allowed.
  void begin(const robot::Commanded& last, const robot::MotionLimits& limits) noexcept;
  /// A cycle later.
  void advance(Seconds period) noexcept;

  /// Of the speed limits, 0 to 1 (1 from the end on).
  [[nodiscard]] double share() const noexcept { return share_; }
  /// `limits` with the speeds of joints and tool cut down to the share.
  [[nodiscard]] robot::MotionLimits scaled(const robot::MotionLimits& limits) const noexcept;

 private:
  Seconds duration_;
  double share_ = 1.0;
};

}  // namespace mirrorarm::control
