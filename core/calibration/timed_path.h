#pragma once

#include <optional>
#include <span>

#include "core/calibration/clock_offset.h"
#include "core/geometry/small_motion.h"

namespace mirrorarm::calibration {

/// A stream of poses asked at any time. Refers to the stream, whose times ascend; at least 2 poses.
class TimedPath {
 public:
  explicit TimedPath(std::span<const TimedPose> poses);

  [[nodiscard]] double begin_s() const { return poses_.front().time_s; }
  [[nodiscard]] double end_s() const { return poses_.back().time_s; }
  [[nodiscard]] double interval_s() const { return interval_s_; }  ///< the median one

  /// Interpolated. Nothing outside, or in a gap of more than four intervals.
  [[nodiscard]] std::optional<RigidTransform> at(double time_s) const;

  /// Motion per second in its own frame, over `half_width_s` before and after.
  [[nodiscard]] std::optional<SmallMotion> velocityAt(double time_s, double half_width_s) const;

 private:
  std::span<const TimedPose> poses_;
  double interval_s_;
};

}  // namespace mirrorarm::calibration
