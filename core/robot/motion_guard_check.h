#pragma once

#include "core/robot/motion_guard.h"
#include "core/robot/motion_guard_tool.h"

namespace mirrorarm::robot {

/// What stands against something, and where.
struct GuardVerdict {
  GuardAction action = GuardAction::kPassed;
  int index = -1;  ///< joint or clearance row

  [[nodiscard]] bool passed() const { return action == GuardAction::kPassed; }
};
/// Of two the graver one.
[[nodiscard]] GuardVerdict graver(const GuardVerdict& one, const GuardVerdict& other);

/// The cap on the flange that is in force, and its name.
struct ToolCap {
  double speed_m_s = 0.0;
  GuardAction action = GuardAction::kToolSpeed;
};
[[nodiscard]] ToolCap toolCap(const Surroundings& around, const MotionLimits& limits);
/// The cap on the hand's points.
[[nodiscard]] double handCap(const Surroundings& around);

/// Whether a state and the stop from it keep all limits. Lives for one cycle of the guard.
class GuardCheck {
 public:
  GuardCheck(const Commanded& last, const Surroundings& around, double period_s, const MotionLimits& limits);

  [[nodiscard]] double period_s() const { return period_s_; }
  [[nodiscard]] const MotionLimits& limits() const { return limits_; }
  [[nodiscard]] const Commanded& last() const { return last_; }
  [[nodiscard]] const Surroundings& around() const { return around_; }
  /// How the flange accelerates at `last` though the joints keep their speed.
  [[nodiscard]] const Eigen::Vector3d& toolCurvature() const { return tool_curvature_; }

  /// The state one cycle after `last` with these accelerations.
  [[nodiscard]] MotionState next(const Joints& a_rad_s2) const;
  /// The flange in the very step from `last` to `next`.
  [[nodiscard]] GuardVerdict step(const MotionState& next) const;
  /// `stop` from `start`, the state after `last`; `tool` at `start`.
  [[nodiscard]] GuardVerdict stop(const MotionState& start, const ToolMotion& tool, const Stop& stop) const;
  /// The same of the joints alone.
  [[nodiscard]] GuardVerdict joints(const MotionState& start, const Stop& stop) const {
    return joints(start, stop, StopCourse(stop, period_s_));
  }

 private:
  [[nodiscard]] GuardVerdict joints(const MotionState& start, const Stop& stop,
                                    const StopCourse& course) const;
  [[nodiscard]] GuardAction joint(Eigen::Index j, const MotionState& start, const Stop& stop,
                                  const StopCourse& course) const;
  [[nodiscard]] GuardVerdict clearances(const MotionState& start, const Stop& stop,
                                        const StopCourse& course) const;
  [[nodiscard]] GuardVerdict tool(const ToolMotion& motion, const StopCourse& course) const;
  [[nodiscard]] GuardVerdict hand(const MotionState& start, const StopCourse& course) const;

  const Commanded& last_;
  const Surroundings& around_;
  double period_s_;
  const MotionLimits& limits_;
  ToolCap cap_;
  Eigen::Vector3d tool_curvature_;
  Joints q_rest_;
};

}  // namespace mirrorarm::robot
