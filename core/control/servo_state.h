#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "core/common/time.h"
#include "core/control/assist_loop.h"
#include "core/control/enabling_switch.h"
#include "core/control/stop_category.h"
#include "core/control/supervisor.h"
#include "core/robot/clearance.h"
#include "core/robot/motion_guard.h"
#include "core/robot/robot_link.h"
#include "core/robot/trajectory.h"

namespace mirrorarm::control {

/// Why a stop cannot be reset now.
enum class ResetRefusal : std::uint8_t {
  kNone,           ///< it can be
  kNotStopped,     ///< there is nothing to reset
  kMoving,         ///< the robot is not at rest yet
  kCausePersists,  ///< see ServoState::lasting
};
/// "none", "not_stopped", "moving", "cause_persists".
[[nodiscard]] std::string_view id(ResetRefusal refusal);

/// Why the motion that was handed over last is not followed.
enum class MotionRefusal : std::uint8_t {
  kNone,
  kStopped,         ///< it was handed over before or while a stop was latched
  kNotEnabled,      ///< the enabling device is not held
  kStartElsewhere,  ///< it begins where the robot is not
  kRobotNotReady,   ///< the robot answers, but takes no commands yet
};
/// "none", "stopped", "not_enabled", "start_elsewhere", "robot_not_ready".
[[nodiscard]] std::string_view id(MotionRefusal refusal);

/// How old the newest news was in one cycle [s]; negative before the first.
struct Ages {
  double frame_s = -1.0;
  double target_s = -1.0;
  double decision_s = -1.0;
  double robot_s = -1.0;
};

/// What one servo cycle did; also an entry of the station's black box.
struct ServoState {
  TimePoint
      time{};  ///< the beat that `commanded` stands for: even steps, even where the thread woke unevenly
  robot::RobotState measured;    ///< newest; joints empty before the first reading
  robot::MotionState commanded;  ///< what was measured while the robot is not driven from here
  robot::Commanded sent;  ///< what went over the wire: differences of it; empty while not driven from here
  robot::GuardAction guard = robot::GuardAction::kPassed;
  int guard_joint = -1;                              ///< whose limit acts, where it is a joint's
  std::optional<robot::ContactKinds> guard_contact;  ///< what is near, where that acts
  Permit permit = Permit::kHold;
  StopReason stop = StopReason::kNone;  ///< latched reason, kNone while free
  StopCategory category = StopCategory::kNone;
  ResetRefusal reset = ResetRefusal::kNotStopped;
  StopReason lasting = StopReason::kNone;  ///< what would stop it again at once
  MotionRefusal refused = MotionRefusal::kNone;
  EnablingPosition enabling = EnablingPosition::kReleased;
  bool enabling_needed = false;
  double soft_start = 1.0;  ///< share of the speed limits that is allowed
  bool at_rest = false;     ///< commanded and measured speed are both nearly zero
  Ages ages;
  AssistState assist;
};

}  // namespace mirrorarm::control
