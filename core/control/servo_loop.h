#pragma once

#include <atomic>
#include <memory>

#include "core/common/latest_value.h"
#include "core/common/ring_log.h"
#include "core/common/time.h"
#include "core/control/supervisor.h"
#include "core/robot/kinematics.h"
#include "core/robot/motion_guard.h"
#include "core/robot/robot_link.h"
#include "core/robot/trajectory.h"

namespace mirrorarm::control {

/// What one servo cycle did; also the black box's entry.
struct ServoState {
  TimePoint time{};
  robot::RobotState measured;
  robot::MotionState commanded;
  robot::GuardAction guard = robot::GuardAction::kPassed;
  Permit permit = Permit::kHold;
  StopReason stop = StopReason::kNone;  ///< latched reason, kNone while free
  bool at_rest = true;                  ///< commanded and measured speed are both nearly zero
};

/// Samples the trajectory in force, passes the motion guard and writes to the robot: once a cycle, from one
/// thread (the servo thread). step() does not allocate, lock or log. Whatever goes wrong, the robot is braked.
class ServoLoop {
 public:
  ServoLoop(const robot::ArmDescription& arm, const robot::MotionLimits& limits, robot::RobotLink& link,
            const SupervisorSettings& supervisor);
  ~ServoLoop();

  /// One cycle. Servo thread only.
  const ServoState& step(TimePoint now) noexcept;

  /// The motion to follow from now on. Control thread only.
  void setTrajectory(const robot::Trajectory& trajectory) noexcept;
  /// When the last frame came and the target was last tracked, and whether the robot is to follow. Control
  /// thread only.
  struct Tracking {
    TimePoint last_frame{};
    TimePoint last_target{};
    bool following = false;
  };
  void setTracking(const Tracking& tracking) noexcept;

  /// Brings the robot to rest from any thread, past every queue; takes effect in the next cycle.
  void stop(StopReason reason) noexcept;
  /// Frees the latch; the robot stays at rest until a new trajectory comes. Any thread.
  void resetStop() noexcept;

  /// The newest state for the control thread; nullptr when none came since the last take.
  [[nodiscard]] const ServoState* takeState() noexcept;

  /// The last 10 s at 200 Hz. Read it only while no cycle runs.
  using BlackBox = RingLog<ServoState, 2048>;
  [[nodiscard]] const BlackBox& blackBox() const noexcept;

 private:
  struct Body;
  std::unique_ptr<Body> body_;
};

}  // namespace mirrorarm::control
