#pragma once

#include <deque>
#include <vector>

#include "core/calibration/clock_offset.h"
#include "core/common/time.h"

namespace mirrorarm::station {

/// Both streams of one movement, each in its own clock's times: the newest minute. One thread.
class MotionStreams {
 public:
  void clear();
  void addRobot(TimePoint time, const RigidTransform& X_BF) { add(robot_, time, X_BF); }
  void addCamera(TimePoint time, const RigidTransform& X_CM) { add(camera_, time, X_CM); }

  /// Of the camera's stream, first to last.
  [[nodiscard]] Seconds duration() const;
  [[nodiscard]] std::vector<calibration::TimedPose> robot() const { return {robot_.begin(), robot_.end()}; }
  [[nodiscard]] std::vector<calibration::TimedPose> camera() const {
    return {camera_.begin(), camera_.end()};
  }

 private:
  using Stream = std::deque<calibration::TimedPose>;
  static void add(Stream& stream, TimePoint time, const RigidTransform& X);
  Stream robot_;
  Stream camera_;
};

}  // namespace mirrorarm::station
