#include "core/robot/motion_limits.h"

#include <algorithm>
#include <array>

namespace mirrorarm::robot {
namespace {

constexpr double kJointSpeed_rad_s = 0.24;
constexpr double kBigJointAcceleration_rad_s2 = 0.5;  // of the two that carry the whole arm
constexpr double kJointAcceleration_rad_s2 = 0.8;
constexpr double kJointJerk_rad_s3 = 40.0;  // full acceleration within 20 ms
constexpr double kToolAcceleration_m_s2 = 0.8;
constexpr int kBigJoints = 2;
constexpr double kLargestMargin = 0.25;  // of a joint's range

struct Profile {
  std::string_view name;
  double tool_speed_m_s;
};
constexpr std::array kProfiles = {Profile{"therapy", 0.24}, Profile{"t1", 0.25}, Profile{"head", 0.13}};

}  // namespace

std::optional<MotionLimits> limitsOf(std::string_view profile, const ArmDescription& arm, double margin_rad) {
  const auto* const found = std::ranges::find(kProfiles, profile, &Profile::name);
  if (found == kProfiles.end()) return std::nullopt;
  const int n = arm.jointCount();
  MotionLimits limits{Joints(n),
                      Joints(n),
                      Joints(n),
                      Joints(n),
                      Joints::Constant(n, kJointJerk_rad_s3),
                      found->tool_speed_m_s,
                      kToolAcceleration_m_s2};
  for (int i = 0; i < n; ++i) {
    const auto& joint = arm.joints[static_cast<std::size_t>(i)];
    const double margin = std::min(margin_rad, kLargestMargin * (joint.upper_rad - joint.lower_rad));
    limits.lower_rad[i] = joint.lower_rad + margin;
    limits.upper_rad[i] = joint.upper_rad - margin;
    limits.max_speed_rad_s[i] = std::min(kJointSpeed_rad_s, joint.max_speed_rad_s);
    limits.max_acceleration_rad_s2[i] =
        i < kBigJoints ? kBigJointAcceleration_rad_s2 : kJointAcceleration_rad_s2;
  }
  return limits;
}

MotionLimits brakingLimits(const MotionLimits& limits) {
  MotionLimits braking = limits;
  braking.max_acceleration_rad_s2 *= limits.stop_share;
  braking.max_jerk_rad_s3 *= limits.stop_share;
  braking.max_tool_acceleration_m_s2 *= limits.stop_share;
  return braking;
}

std::vector<std::string_view> limitProfiles() {
  std::vector<std::string_view> names;
  for (const auto& profile : kProfiles) names.push_back(profile.name);
  return names;
}

}  // namespace mirrorarm::robot
