#pragma once

#include "core/control/assist.h"
#include "core/control/force_watch.h"
#include "core/robot/kinematics.h"
#include "core/robot/robot_link.h"

namespace mirrorarm::control {

/// How the robot is to treat the arm that it carries.
struct AssistSettings {
  Eigen::Vector3d p_FE_F = Eigen::Vector3d::Zero();  ///< where the arm hangs, in the flange's frame
  ForceSettings force;
  AssistPlan plan;
};

/// What it does.
struct AssistState {
  ForceReading force;
  bool gives_way = false;  ///< else the robot holds its position, whatever the level
  double level = 1.0;      ///< of help, 0 to 1
  double error_m = 0.0;    ///< of the sling, commanded to measured: what the springs give way
};

/// Feels the force at the sling and sets the springs, once a servo cycle. Servo thread only; does not
/// allocate.
class AssistLoop {
 public:
  AssistLoop(const AssistSettings& settings, robot::GivesWay gives_way, Seconds period);

  /// Other help than before, from the next cycle on: the level goes there at the plan's rate. A level beyond
  /// 0 and 1 is brought back to them; one that is not finite changes nothing.
  void choose(const Help& help) noexcept;

  /// The force that the newest reading tells of. Before the watchdogs.
  void feel(const robot::RobotState& measured, const robot::Kinematics& kinematics) noexcept;

  /// The level for the next cycle: softer while the force is near its limit, adapted to the error while the
  /// robot follows (`learning`), or back to the one that was chosen. After the command of this cycle is
  /// known.
  void adapt(const robot::Joints& commanded, const robot::Joints& measured,
             const robot::Kinematics& kinematics, bool learning) noexcept;

  /// The springs for the next command; empty where the robot does not give way.
  [[nodiscard]] robot::Compliance compliance(int joints) const noexcept;
  [[nodiscard]] const AssistState& state() const noexcept { return state_; }

 private:
  [[nodiscard]] double nextLevel(bool learning) const noexcept;
  [[nodiscard]] robot::Jacobian slingJacobian(const robot::Joints& q,
                                              const robot::Kinematics& kinematics) const noexcept;
  const Eigen::Vector3d p_FE_F_;
  const AssistPlan plan_;
  Help help_;
  const robot::GivesWay gives_way_;
  const Seconds period_;
  ForceWatch watch_;
  AssistState state_;
};

}  // namespace mirrorarm::control
