#pragma once

#include <cmath>
#include <optional>

#include "core/robot/robot_link.h"

namespace mirrorarm::control::testing {

/// An arm that takes each command as its position one cycle later, and can be made to fail.
class FakeRobot final : public robot::RobotLink {
 public:
  explicit FakeRobot(const robot::Joints& q, Seconds period = Seconds(0.005))
      : period_(period), q_(q), next_(q), v_(robot::Joints::Zero(q.size())) {}

  Expected<robot::RobotState, robot::LinkFault> read() noexcept override {
    v_ = (next_ - q_) / period().count();
    q_ = next_;
    if (fault != robot::LinkFault::kNone) return unexpected(robot::LinkFault(fault));
    robot::RobotState state{.q_rad = q_,
                            .v_rad_s = v_,
                            .external_torque_nm = external_torque_nm,
                            .measured_at = claims.value_or(now)};
    if (lies) state.q_rad[0] = std::nan("");
    return state;
  }

  Expected<void, robot::LinkFault> command(const robot::RobotCommand& command) noexcept override {
    ++commands;
    if (fault != robot::LinkFault::kNone) return unexpected(robot::LinkFault(fault));
    compliance = command.compliance;
    if (!stuck) next_ = command.q_rad;
    return {};
  }

  void halt() noexcept override {
    ++halts;
    next_ = q_;
  }

  Seconds period() const noexcept override { return period_; }
  robot::GivesWay givesWay() const noexcept override { return gives_way; }
  bool takesCommands() const noexcept override { return !monitors; }
  const robot::Joints& q() const { return q_; }

  TimePoint now{};
  std::optional<TimePoint> claims;  ///< when it measured, as it says
  robot::LinkFault fault = robot::LinkFault::kNone;
  robot::GivesWay gives_way = robot::GivesWay::kNot;  ///< before a loop is made with it
  robot::Joints external_torque_nm{};
  robot::Compliance compliance{};  ///< of the newest command
  bool stuck = false;
  bool lies = false;
  bool monitors = false;
  int commands = 0;
  int halts = 0;

 private:
  Seconds period_;
  robot::Joints q_, next_, v_;
};

}  // namespace mirrorarm::control::testing
