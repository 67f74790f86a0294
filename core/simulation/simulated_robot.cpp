#include "core/simulation/simulated_robot.h"

#include <algorithm>

#include "core/simulation/counter_random.h"

namespace mirrorarm::simulation {
namespace {

constexpr Clock::duration kStep = std::chrono::milliseconds(1);
constexpr Clock::duration kLongestGap = std::chrono::milliseconds(500);

}  // namespace

SimulatedRobot::SimulatedRobot(const robot::ArmDescription& arm, const robot::Joints& start,
                               const TimeSource& time, std::uint64_t seed)
    : time_(time), drives_(arm, start), advanced_to_(time.now()), seed_(seed) {
  history_.add({advanced_to_, start});
}

void SimulatedRobot::remember(TimePoint time) noexcept {
  const std::lock_guard lock(mutex_);
  history_.add({time, drives_.q()});
}

void SimulatedRobot::advance(TimePoint now) noexcept {
  // A host that slept long finds the robot where its last commands led it: nothing happens in between.
  advanced_to_ = std::max(advanced_to_, now - kLongestGap);
  while (advanced_to_ + kStep <= now) {
    advanced_to_ += kStep;
    drives_.advance(advanced_to_, kStep);
    remember(advanced_to_);
  }
}

Expected<robot::RobotState, robot::LinkFault> SimulatedRobot::read() noexcept {
  advance(time_.now());
  if (silent_.load(std::memory_order_relaxed)) return unexpected(robot::LinkFault::kNoAnswer);
  robot::RobotState state{.q_rad = drives_.q(), .v_rad_s = drives_.v(), .measured_at = advanced_to_};
  for (double& angle : state.q_rad) angle += kAngleNoise_rad * counterNormal(seed_, reading_++);
  return state;
}

Expected<void, robot::LinkFault> SimulatedRobot::command(const robot::RobotCommand& command) noexcept {
  advance(time_.now());
  if (silent_.load(std::memory_order_relaxed)) {
    drives_.halt();
    return unexpected(robot::LinkFault::kNoAnswer);
  }
  if (command.q_rad.size() != drives_.q().size() || !command.q_rad.allFinite())
    return unexpected(robot::LinkFault::kDriveFault);
  drives_.command(advanced_to_, command.q_rad);
  return {};
}

void SimulatedRobot::halt() noexcept {
  advance(time_.now());
  drives_.halt();
}

robot::Joints SimulatedRobot::jointsAt(TimePoint time) const {
  const std::lock_guard lock(mutex_);
  std::size_t low = 0, high = history_.size() - 1;
  if (time <= history_[low].time) return history_[low].q;
  if (time >= history_[high].time) return history_[high].q;
  while (high - low > 1) {
    const std::size_t middle = (low + high) / 2;
    (history_[middle].time <= time ? low : high) = middle;
  }
  const Moment& before = history_[low];
  const Moment& after = history_[high];
  const double share = secondsBetween(before.time, time) / secondsBetween(before.time, after.time);
  return before.q + share * (after.q - before.q);
}

}  // namespace mirrorarm::simulation
