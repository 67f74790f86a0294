#pragma once

#include "core/common/time.h"
#include "core/robot/compliance.h"

namespace mirrorarm::control {

/// The springs that help, one number each.
struct Stiffness {
  double joint_nm_rad = 0.0;
  double tool_n_m = 0.0;
  double tool_turn_nm_rad = 0.0;
};

/// How much the robot is to help.
struct Help {
  bool adapts = false;  ///< to the error, from the level where it is; false: goes to `level` and stays there
  double level = 1.0;   ///< 0 the least help, 1 the most
  bool operator==(const Help&) const = default;
};

/// What the therapist plans for one patient.
struct AssistPlan {
  Help help;  ///< to begin with
  Stiffness least{100.0, 200.0, 10.0};
  Stiffness most{1000.0, 2000.0, 100.0};
  double gain_1_m_s = 6.0;       ///< by how much the level grows a second for each metre of error
  double forgetting_1_s = 0.15;  ///< share of the level that is lost a second
  double free_error_m = 0.003;   ///< an error that needs no help
  double max_rate_1_s = 0.5;     ///< of the level, either way: stiffness never jumps
};

/// Help as much as needed: the level a period later. It grows with the error and is forgotten steadily, so
/// that a patient who can do it himself soon has to, and one who leans on the robot is not carried for ever:
///     d level / dt = gain * max(0, error - free) - forgetting * level,
/// its rate bounded, the level within 0 and 1. An error that is not finite changes nothing.
/// Sources: Wolbrecht et al., IEEE TNSRE 16(3), 2008 (error-based adaptation, forgetting against slacking);
/// Emken, Bobrow, Reinkensmeyer, ICORR 2005.
[[nodiscard]] double assistAfter(double level, double error_m, const AssistPlan& plan,
                                 Seconds period) noexcept;

/// The level a period later while the robot is to be soft: to 0 at the greatest rate.
[[nodiscard]] double softenedAfter(double level, const AssistPlan& plan, Seconds period) noexcept;

/// The springs at `level`, straight between the plan's least and most. Does not allocate.
[[nodiscard]] robot::Compliance complianceAt(double level, const AssistPlan& plan, int joints) noexcept;

}  // namespace mirrorarm::control
