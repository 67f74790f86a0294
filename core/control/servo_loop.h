#pragma once

#include <memory>
#include <optional>

#include "core/common/time.h"
#include "core/control/assist_loop.h"
#include "core/control/servo_state.h"
#include "core/control/supervisor.h"
#include "core/robot/clearance.h"
#include "core/robot/kinematics.h"
#include "core/robot/robot_link.h"
#include "core/robot/trajectory.h"

namespace mirrorarm::control {

/// Samples the trajectory in force, passes the motion guard and writes to the robot: once a cycle, from one
/// thread (the servo thread). step() does not allocate, lock or log.
///
/// Whatever goes wrong, the robot is braked, in the category that the reason asks for (StopCategory): by
/// commands within the limits, or by its own halt. After a halt, a command that did not reach it, and before
/// the first cycle, it is driven only once it was read at rest. A motion begins softly (SoftStart) from where
/// the robot is, or not at all.
class ServoLoop {
 public:
  /// `clearance` is what the arm must keep away from; nothing by itself.
  ServoLoop(const robot::ArmDescription& arm, const robot::MotionLimits& limits, robot::RobotLink& link,
            const SupervisorSettings& supervisor, const AssistSettings& assist = {},
            robot::Clearance clearance = {});
  ~ServoLoop();

  /// One cycle. Servo thread only.
  const ServoState& step(TimePoint now) noexcept;

  /// The motion to follow from its start on, the one before goes on until then; ServoState::refused tells why
  /// one is not followed. One that is handed over while a stop is latched is never followed. After a hold the
  /// motion in force goes on if the robot has hardly left it; else it waits for a new one. Control thread
  /// only.
  void setTrajectory(const robot::Trajectory& trajectory) noexcept;
  /// When the last frame came and the target was last tracked, and whether the robot is to follow. Each call
  /// is a sign of life: while following it must not fail to come. Control thread only.
  struct Tracking {
    TimePoint last_frame{};
    TimePoint last_target{};
    bool following = false;
  };
  void setTracking(const Tracking& tracking) noexcept;

  /// How much the robot is to help from the next cycle on, where it gives way; see AssistLoop::choose().
  /// Control thread only.
  void setHelp(const Help& help) noexcept;

  /// Brings the robot to rest from any thread, past every queue; takes effect in the next cycle.
  void stop(StopReason reason) noexcept;
  /// Asks to free the latch. Granted or refused in the next cycle, as ServoState::reset says: not while the
  /// robot moves or the cause persists. The robot stays at rest until a trajectory comes that was set after
  /// the reset. Any thread.
  void resetStop() noexcept;
  /// Where the operator holds the enabling device; to be said again and again, see EnablingSwitch. Any
  /// thread.
  void setEnabling(EnablingPosition position) noexcept;

  /// The states of the cycles one after another, each once; nothing when all are taken. Whoever stays away
  /// for more than 2048 cycles misses the following ones. Control thread only.
  [[nodiscard]] std::optional<ServoState> takeState() noexcept;

 private:
  struct Body;
  std::unique_ptr<Body> body_;
};

}  // namespace mirrorarm::control
