#include "core/control/assist.h"

#include <algorithm>
#include <cmath>

namespace mirrorarm::control {

double assistAfter(double level, double error_m, const AssistPlan& plan, Seconds period) noexcept {
  if (!std::isfinite(error_m)) return level;
  const double needed = plan.gain_1_m_s * std::max(0.0, std::abs(error_m) - plan.free_error_m);
  const double rate = std::clamp(needed - plan.forgetting_1_s * level, -plan.max_rate_1_s, plan.max_rate_1_s);
  return std::clamp(level + rate * period.count(), 0.0, 1.0);
}

double softenedAfter(double level, const AssistPlan& plan, Seconds period) noexcept {
  return std::max(0.0, level - plan.max_rate_1_s * period.count());
}

robot::Compliance complianceAt(double level, const AssistPlan& plan, int joints) noexcept {
  const double share = std::clamp(level, 0.0, 1.0);
  const auto between = [&](double Stiffness::*spring) {
    return std::lerp(plan.least.*spring, plan.most.*spring, share);
  };
  robot::Compliance compliance;
  compliance.joint_stiffness_nm_rad = robot::Joints::Constant(joints, between(&Stiffness::joint_nm_rad));
  compliance.tool_stiffness.head<3>().setConstant(between(&Stiffness::tool_n_m));
  compliance.tool_stiffness.tail<3>().setConstant(between(&Stiffness::tool_turn_nm_rad));
  return compliance;
}

}  // namespace mirrorarm::control
