#pragma once

#include "core/robot/robot_link.h"

namespace mirrorarm::control::testing {

/// An arm that takes each command as its position one cycle later, and can be made to fail.
class FakeRobot final : public robot::RobotLink {
 public:
  explicit FakeRobot(const robot::Joints& q) : q_(q), next_(q), v_(robot::Joints::Zero(q.size())) {}

  Expected<robot::RobotState, robot::LinkFault> read() noexcept override {
    v_ = (next_ - q_) / period().count();
    q_ = next_;
    if (fault != robot::LinkFault::kNone) return unexpected(robot::LinkFault(fault));
    robot::RobotState state{.q_rad = q_, .v_rad_s = v_, .measured_at = now};
    if (lies) state.q_rad[0] = std::nan("");
    return state;
  }

  Expected<void, robot::LinkFault> command(const robot::RobotCommand& command) noexcept override {
    ++commands;
    if (fault != robot::LinkFault::kNone) return unexpected(robot::LinkFault(fault));
    if (!stuck) next_ = command.q_rad;
    return {};
  }

  void halt() noexcept override {
    ++halts;
    next_ = q_;
  }

  Seconds period() const noexcept override { return Seconds(0.005); }
  const robot::Joints& q() const { return q_; }

  TimePoint now{};
  robot::LinkFault fault = robot::LinkFault::kNone;
  bool stuck = false;
  bool lies = false;
  int commands = 0;
  int halts = 0;

 private:
  robot::Joints q_, next_, v_;
};

}  // namespace mirrorarm::control::testing
