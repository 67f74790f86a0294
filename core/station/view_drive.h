#pragma once

#include <vector>

#include "core/control/servo_loop.h"
#include "core/robot/motion_limits.h"

namespace mirrorarm::station {

/// One motion of the robot to a view and the rest there. Control thread only.
class ViewDrive {
 public:
  enum class State {
    kIdle,      ///< no motion is wanted
    kUnderWay,  ///< moving, or coming to rest
    kThere,     ///< at rest where the path ends
    kStuck,     ///< the motion has ended long ago, and the robot is not there
  };

  ViewDrive(control::ServoLoop& servo, const robot::MotionLimits& limits) : servo_(servo), limits_(limits) {}

  /// Along the way points to rest at the last, from the robot's rest at `state`. `at_least`: not faster.
  void go(const std::vector<robot::Joints>& path, const control::ServoState& state,
          Seconds at_least = Seconds(0.0));
  /// Brings the robot to rest where it is; kIdle from then on.
  void halt();
  /// The robot stays where it is; kIdle from then on.
  void finish() { state_ = State::kIdle; }

  State update(const control::ServoState& state, TimePoint now);
  [[nodiscard]] State state() const { return state_; }
  /// Since when it is there; good while kThere.
  [[nodiscard]] TimePoint thereSince() const { return there_since_; }

 private:
  control::ServoLoop& servo_;
  robot::MotionLimits limits_;
  State state_ = State::kIdle;
  robot::Trajectory trajectory_;
  TimePoint there_since_{};
};

}  // namespace mirrorarm::station
