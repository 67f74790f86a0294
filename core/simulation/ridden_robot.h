#pragma once

#include <memory>
#include <string>

#include "core/common/expected.h"
#include "core/robot/robot_link.h"
#include "core/simulation/joint_trail.h"

namespace mirrorarm::simulation {

/// How far a robot's joints may be from where the bench is laid out for.
inline constexpr double kSamePosture_rad = 0.05;

/// A robot from outside that carries the bench's hand. What it measured is kept as its only reader, the servo
/// thread, reads it: the world rides on that, and the robot is asked nothing for it.
class RiddenRobot final : public robot::RobotLink {
 public:
  /// Waits for the first state. The error is why `link` cannot carry the hand: it tells none within
  /// `patience`, has another number of joints than `start`, or stands elsewhere. It is not moved there.
  [[nodiscard]] static Expected<std::unique_ptr<RiddenRobot>, std::string> mount(
      std::unique_ptr<robot::RobotLink> link, const robot::Joints& start, Seconds patience);

  [[nodiscard]] Expected<robot::RobotState, robot::LinkFault> read() noexcept override;
  [[nodiscard]] Expected<void, robot::LinkFault> command(
      const robot::RobotCommand& command) noexcept override {
    return link_->command(command);
  }
  void halt() noexcept override { link_->halt(); }
  [[nodiscard]] Seconds period() const noexcept override { return link_->period(); }
  [[nodiscard]] bool setsThePace() const noexcept override { return link_->setsThePace(); }
  void awaitCycle(Seconds longest) noexcept override { link_->awaitCycle(longest); }
  [[nodiscard]] bool takesCommands() const noexcept override { return link_->takesCommands(); }
  [[nodiscard]] robot::GivesWay givesWay() const noexcept override { return link_->givesWay(); }

  /// As measured, interpolated; the oldest or newest where `time` lies outside the last seconds. Any thread.
  [[nodiscard]] robot::Joints jointsAt(TimePoint time) const { return trail_.at(time); }

 private:
  RiddenRobot(std::unique_ptr<robot::RobotLink> link, const robot::RobotState& first)
      : link_(std::move(link)), joints_(first.q_rad.size()), trail_(first.measured_at, first.q_rad) {}

  std::unique_ptr<robot::RobotLink> link_;
  const Eigen::Index joints_;
  JointTrail trail_;
};

}  // namespace mirrorarm::simulation
