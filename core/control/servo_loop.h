#pragma once

#include <memory>
#include <optional>

#include "core/common/time.h"
#include "core/control/supervisor.h"
#include "core/robot/kinematics.h"
#include "core/robot/motion_guard.h"
#include "core/robot/robot_link.h"
#include "core/robot/trajectory.h"

namespace mirrorarm::control {

/// What one servo cycle did; also an entry of the station's black box.
struct ServoState {
  TimePoint
      time{};  ///< the beat that `commanded` stands for: even steps, even where the thread woke unevenly
  robot::RobotState measured;    ///< newest; joints empty before the first reading
  robot::MotionState commanded;  ///< what was measured while the robot is not driven from here
  robot::Commanded sent;  ///< what went over the wire: whole cycles' speed; empty while not driven from here
  robot::GuardAction guard = robot::GuardAction::kPassed;
  Permit permit = Permit::kHold;
  StopReason stop = StopReason::kNone;  ///< latched reason, kNone while free
  bool at_rest = false;                 ///< commanded and measured speed are both nearly zero
};

/// Samples the trajectory in force, passes the motion guard and writes to the robot: once a cycle, from one
/// thread (the servo thread). step() does not allocate, lock or log.
///
/// Whatever goes wrong, the robot is braked: by commands within the limits where it still obeys (operator,
/// camera, target, an exception elsewhere), by its own halt where that is in doubt (silent, faulty, not where
/// it was told to be, a servo cycle missed). From then on, and before the first cycle, it is driven only once
/// it was read at rest.
class ServoLoop {
 public:
  ServoLoop(const robot::ArmDescription& arm, const robot::MotionLimits& limits, robot::RobotLink& link,
            const SupervisorSettings& supervisor);
  ~ServoLoop();

  /// One cycle. Servo thread only.
  const ServoState& step(TimePoint now) noexcept;

  /// The motion to follow from now on. One that is handed over while a stop is latched is never followed.
  /// After a hold the motion in force goes on if the robot has hardly left it; else it waits for a new one.
  /// Control thread only.
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
  /// Frees the latch; the robot stays at rest until a trajectory comes that was set after this. Any thread.
  void resetStop() noexcept;

  /// The states of the cycles one after another, each once; nothing when all are taken. Whoever stays away
  /// for more than 256 cycles misses the following ones. Control thread only.
  [[nodiscard]] std::optional<ServoState> takeState() noexcept;

 private:
  struct Body;
  std::unique_ptr<Body> body_;
};

}  // namespace mirrorarm::control
