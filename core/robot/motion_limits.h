#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/robot/arm_description.h"

namespace mirrorarm::robot {

/// What the robot may do beside the patient. The paper writes 0.24 mm/s and 0.8 mm/s^2; docs/adr tells why
/// these are read per joint [rad/s] with a cap on the tool [m/s].
struct MotionLimits {
  Joints lower_rad;
  Joints upper_rad;
  Joints max_speed_rad_s;
  Joints max_acceleration_rad_s2;
  Joints max_jerk_rad_s3;  ///< the paper names none: see docs/adr/0010-following-without-rests.md
  double max_tool_speed_m_s = 0.0;
  double max_tool_acceleration_m_s2 = 0.0;
  /// Farther than this from where it was sent the robot is braked.
  double max_following_error_rad = 0.10;
  double stop_share = 2.0;  ///< of acceleration and jerk, where somebody calls a stop
};

/// The same limits with what a called stop may use of acceleration and jerk. docs/adr/0011-motion-guard.md.
[[nodiscard]] MotionLimits brakingLimits(const MotionLimits& limits);

/// Named profiles: "therapy" (joints 0.24 rad/s, 0.5 or 0.8 rad/s^2 and 40 rad/s^3,
/// tool 0.24 m/s and 0.8 m/s^2), "t1"
/// (the same joints, tool 0.25 m/s) and "head" (tool 0.13 m/s). Joint ranges come from the arm, `margin_rad`
/// inside (at most a quarter of the range). Nothing for an unknown name.
[[nodiscard]] std::optional<MotionLimits> limitsOf(std::string_view profile, const ArmDescription& arm,
                                                   double margin_rad = 0.035);
[[nodiscard]] std::vector<std::string_view> limitProfiles();

}  // namespace mirrorarm::robot
