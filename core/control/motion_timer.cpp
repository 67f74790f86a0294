#include "core/control/motion_timer.h"

#include <algorithm>
#include <cmath>

#include "core/robot/motion_guard_tool.h"

namespace mirrorarm::control {
namespace {

constexpr double kInside = 0.99;     // share of the limits that is planned with; the guard enforces the rest
constexpr double kInsideJerk = 0.9;  // a servo beat that catches up runs through a motion 2 % faster
constexpr int kSamples = 24;
constexpr int kRounds = 4;
constexpr double kSlack = 1.001;

robot::MotionLimits inside(robot::MotionLimits limits) {
  limits.max_speed_rad_s *= kInside;
  limits.max_acceleration_rad_s2 *= kInside;
  limits.max_jerk_rad_s3 *= kInsideJerk;
  limits.max_tool_speed_m_s *= kInside;
  limits.max_tool_acceleration_m_s2 *= kInside;
  return limits;
}

}  // namespace

MotionTimer::MotionTimer(const robot::ArmDescription& arm, const robot::MotionLimits& limits)
    : limits_(inside(limits)), kinematics_(arm) {}

robot::Trajectory MotionTimer::pursuit(const robot::MotionState& from, const robot::MovingGoal& goal,
                                       TimePoint start, const robot::PursuitTimes& times) const {
  robot::MotionLimits slower = limits_;
  robot::Trajectory motion = robot::Trajectory::pursuit(from, goal, start, slower, times);
  for (int round = 0; round < kRounds; ++round) {
    const Excess excess = excessOf(motion);
    if (std::max(excess.speed, excess.acceleration) <= kSlack) break;
    slower.max_speed_rad_s /= std::max(1.0, excess.speed);
    slower.max_acceleration_rad_s2 /= std::max(1.0, excess.acceleration);
    motion = robot::Trajectory::pursuit(from, goal, start, slower, times);
  }
  return motion;
}

robot::Trajectory MotionTimer::through(const robot::MotionState& from,
                                       std::span<const robot::Joints> waypoints, TimePoint start) const {
  robot::Trajectory motion = robot::Trajectory::through(from, waypoints, start, limits_);
  for (int round = 0; round < kRounds; ++round) {
    const Excess excess = excessOf(motion);
    const double stretch = std::max(excess.speed, std::sqrt(excess.acceleration));
    if (stretch <= kSlack) break;
    motion = robot::Trajectory::through(from, waypoints, start, limits_, stretch * motion.duration());
  }
  return motion;
}

Eigen::Vector3d MotionTimer::flangeMotion(const robot::Joints& q_rad, const robot::Joints& joints) const {
  return robot::toolOf(kinematics_.jacobian(q_rad), joints);
}

MotionTimer::Excess MotionTimer::excessOf(const robot::Trajectory& motion) const {
  const Seconds step = motion.duration() / kSamples;
  Excess excess;
  if (step <= Seconds::zero()) return excess;
  const robot::MotionState first = motion.at(motion.start());
  Eigen::Vector3d last = flangeMotion(first.q_rad, first.v_rad_s);
  const double speed_limit = std::max(limits_.max_tool_speed_m_s, last.norm());
  const double acceleration_limit =
      std::max(limits_.max_tool_acceleration_m_s2, flangeMotion(first.q_rad, first.a_rad_s2).norm());
  for (int i = 1; i <= kSamples; ++i) {
    const robot::MotionState now = motion.at(motion.start() + toClock(i * step));
    const Eigen::Vector3d v = flangeMotion(now.q_rad, now.v_rad_s);
    const double acceleration = (v - last).norm() / step.count();
    excess.speed = std::max(excess.speed, v.norm() / speed_limit);
    excess.acceleration = std::max(excess.acceleration, acceleration / acceleration_limit);
    last = v;
  }
  return excess;
}

}  // namespace mirrorarm::control
