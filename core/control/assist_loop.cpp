#include "core/control/assist_loop.h"

#include <algorithm>
#include <cmath>

#include "core/control/force_estimate.h"

namespace mirrorarm::control {

AssistLoop::AssistLoop(const AssistSettings& settings, robot::GivesWay gives_way, Seconds period)
    : p_FE_F_(settings.p_FE_F),
      plan_(settings.plan),
      gives_way_(gives_way),
      period_(period),
      watch_(settings.force) {
  choose(plan_.help);
  state_.gives_way = gives_way_ != robot::GivesWay::kNot;
  if (state_.gives_way) state_.level = help_.level;
}

void AssistLoop::choose(const Help& help) noexcept {
  if (std::isfinite(help.level)) help_ = {help.adapts, std::clamp(help.level, 0.0, 1.0)};
}

robot::Jacobian AssistLoop::slingJacobian(const robot::Joints& q,
                                          const robot::Kinematics& kinematics) const noexcept {
  return jacobianAt(kinematics.flange(q).linear() * p_FE_F_, kinematics.jacobian(q));
}

void AssistLoop::feel(const robot::RobotState& measured, const robot::Kinematics& kinematics) noexcept {
  const bool known =
      measured.external_torque_nm.size() > 0 && measured.external_torque_nm.size() == measured.q_rad.size();
  state_.force =
      known ? watch_.update(
                  wrenchOf(measured.external_torque_nm, slingJacobian(measured.q_rad, kinematics)).head<3>(),
                  period_)
            : watch_.forget();
}

void AssistLoop::adapt(const robot::Joints& commanded, const robot::Joints& measured,
                       const robot::Kinematics& kinematics, bool learning) noexcept {
  if (gives_way_ == robot::GivesWay::kNot) return;
  const robot::Jacobian J = slingJacobian(measured, kinematics);
  const Eigen::Vector3d error = J.topRows<3>().lazyProduct(commanded - measured);
  state_.error_m = error.norm();
  state_.level = nextLevel(learning);
}

double AssistLoop::nextLevel(bool learning) const noexcept {
  const double level = state_.level;
  if (state_.force.level >= ForceLevel::kSoften) return softenedAfter(level, plan_, period_);
  if (state_.force.level == ForceLevel::kWarning) return level;
  if (help_.adapts) return learning ? assistAfter(level, state_.error_m, plan_, period_) : level;
  const double step = plan_.max_rate_1_s * period_.count();
  return level + std::clamp(help_.level - level, -step, step);
}

robot::Compliance AssistLoop::compliance(int joints) const noexcept {
  if (gives_way_ == robot::GivesWay::kNot) return {};
  return complianceAt(state_.level, plan_, joints);
}

}  // namespace mirrorarm::control
