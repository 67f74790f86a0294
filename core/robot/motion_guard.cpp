#include "core/robot/motion_guard.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace mirrorarm::robot {
namespace {

constexpr double kSlack = 1e-6;  // share of a limit that rounding may use up

/// The fastest speed towards a point `room` away from which `deceleration`, applied from the next cycle on,
/// still comes to rest before it. Exact for whole cycles: with u = deceleration * period, speed v and n =
/// floor(v / u) the way of this and all braking cycles is period * ((n + 1) v - n (n + 1) u / 2), here solved
/// for v.
double approachSpeed(double room, double deceleration, double period_s) {
  if (!(room > 0.0)) return 0.0;
  const double u = deceleration * period_s;
  const double r = room / (u * period_s);
  const double n = std::floor(0.5 * (std::sqrt(1.0 + 8.0 * r) - 1.0));
  return u * (r / (n + 1.0) + 0.5 * n);
}

struct Interval {
  double least = 0.0;
  double most = 0.0;
  [[nodiscard]] double clamp(double number) const { return std::clamp(number, least, most); }
  [[nodiscard]] bool has(double number) const { return number >= least && number <= most; }
};

/// The speeds that one joint may take on in this cycle.
struct JointBounds {
  Interval position, speed, acceleration;

  JointBounds(const Commanded& last, Eigen::Index j, double period_s, const MotionLimits& limits) {
    const double q = last.q_rad[j], v = last.v_rad_s[j];
    const double a = limits.max_acceleration_rad_s2[j], v_max = limits.max_speed_rad_s[j];
    acceleration = {v - a * period_s, v + a * period_s};
    position = {-approachSpeed(q - limits.lower_rad[j], a, period_s),
                approachSpeed(limits.upper_rad[j] - q, a, period_s)};
    speed = {-v_max, v_max};
  }

  /// Into all three; where they contradict each other the acceleration wins, then the position.
  [[nodiscard]] double clamp(double v) const { return acceleration.clamp(position.clamp(speed.clamp(v))); }

  /// What forbids `v`, beyond rounding.
  [[nodiscard]] GuardAction judge(double v) const {
    const double slack = kSlack * (acceleration.most - acceleration.least);
    const auto allows = [&](const Interval& interval) {
      return Interval{interval.least - slack, interval.most + slack}.has(v);
    };
    if (!allows(position)) return GuardAction::kPosition;
    if (!allows(speed)) return GuardAction::kSpeed;
    if (!allows(acceleration)) return GuardAction::kAcceleration;
    return GuardAction::kPassed;
  }
};

/// One cycle: what was last, the limits, and the speeds that they leave.
class Cycle {
 public:
  Cycle(const Commanded& last, const Jacobian& jacobian, double period_s, const MotionLimits& limits)
      : last_(last), J_(jacobian), period_s_(period_s), limits_(limits) {}

  [[nodiscard]] Eigen::Index jointCount() const { return last_.q_rad.size(); }
  [[nodiscard]] JointBounds bounds(Eigen::Index j) const { return {last_, j, period_s_, limits_}; }

  [[nodiscard]] Commanded after(const Joints& v) const { return {last_.q_rad + period_s_ * v, v}; }

  /// All joints slowed down by the same share, the largest that joints and tool allow.
  [[nodiscard]] Joints brakingSpeed() const {
    double share = 1.0;
    for (Eigen::Index j = 0; j < jointCount(); ++j)
      share = std::min(share, shareOf(limits_.max_acceleration_rad_s2[j], std::abs(last_.v_rad_s[j])));
    share = std::min(share, shareOf(limits_.max_tool_acceleration_m_s2, toolSpeed(last_.v_rad_s).norm()));
    Joints v = (1.0 - share) * last_.v_rad_s;
    for (Eigen::Index j = 0; j < jointCount(); ++j) v[j] = bounds(j).clamp(v[j]);
    return v;
  }

  [[nodiscard]] bool toolAllows(const Joints& v) const {
    return toolSpeed(v).norm() <= (1.0 + kSlack) * limits_.max_tool_speed_m_s &&
           toolSpeed(v - last_.v_rad_s).norm() <= (1.0 + kSlack) * toolStep();
  }

  /// The point nearest to `wanted` on the line from braking to it that tool speed and acceleration allow.
  /// Every point of the line keeps the joints' bounds, because both ends do.
  [[nodiscard]] Joints withinTool(const Joints& wanted) const {
    const Joints braking = brakingSpeed();
    const Joints way = wanted - braking;
    const Eigen::Vector3d along = toolSpeed(way);
    const double by_speed = reach(toolSpeed(braking), along, limits_.max_tool_speed_m_s);
    const double by_step = reach(toolSpeed(braking - last_.v_rad_s), along, toolStep());
    return braking + std::min(by_speed, by_step) * way;
  }

 private:
  [[nodiscard]] double shareOf(double acceleration, double speed) const {
    return speed > 0.0 ? acceleration * period_s_ / speed : 1.0;
  }
  [[nodiscard]] double toolStep() const { return limits_.max_tool_acceleration_m_s2 * period_s_; }
  [[nodiscard]] Eigen::Vector3d toolSpeed(const Joints& v) const {
    Eigen::Vector3d speed = Eigen::Vector3d::Zero();
    for (Eigen::Index j = 0; j < v.size(); ++j) speed += J_.block<3, 1>(0, j) * v[j];
    return speed;
  }

  /// The largest share of 1 for which |from + share * along| <= radius; 0 when there is none.
  [[nodiscard]] static double reach(const Eigen::Vector3d& from, const Eigen::Vector3d& along,
                                    double radius) {
    const double aa = along.squaredNorm(), ab = along.dot(from);
    const double c = from.squaredNorm() - radius * radius;
    const double discriminant = ab * ab - aa * c;
    if (c > 0.0 || !(discriminant >= 0.0)) return 0.0;
    if (aa == 0.0) return 1.0;
    return std::clamp((std::sqrt(discriminant) - ab) / aa, 0.0, 1.0);
  }

  const Commanded& last_;
  const Jacobian& J_;
  double period_s_;
  const MotionLimits& limits_;
};

bool isUsable(const Commanded& wish, Eigen::Index joints) {
  return wish.q_rad.size() == joints && wish.v_rad_s.size() == joints && wish.q_rad.allFinite() &&
         wish.v_rad_s.allFinite();
}

/// Graver actions come first in the enumeration; "passed" is the mildest.
GuardAction graver(GuardAction one, GuardAction other) {
  if (one == GuardAction::kPassed) return other;
  if (other == GuardAction::kPassed) return one;
  return std::min(one, other);
}

/// Speeds towards the wish, and what stood against reaching it in this cycle.
struct Approach {
  Joints v_rad_s;
  GuardAction action = GuardAction::kPassed;
};

Approach approach(const Cycle& cycle, const Commanded& wish, const Commanded& last, double period_s,
                  const MotionLimits& limits) {
  Approach result{Joints::Zero(cycle.jointCount()), GuardAction::kPassed};
  for (Eigen::Index j = 0; j < cycle.jointCount(); ++j) {
    const JointBounds bounds = cycle.bounds(j);
    const double a = limits.max_acceleration_rad_s2[j];
    const double exact = (wish.q_rad[j] - last.q_rad[j]) / period_s;
    const double own = bounds.speed.clamp(wish.v_rad_s[j]);
    GuardAction action = bounds.judge(exact);
    // Arriving at a speed that cannot be kept up with next cycle would overshoot.
    if (action == GuardAction::kPassed && std::abs(exact - own) > (1.0 + kSlack) * a * period_s)
      action = GuardAction::kAcceleration;
    const double behind = wish.q_rad[j] - last.q_rad[j] - own * period_s;
    const double catching_up = std::copysign(approachSpeed(std::abs(behind), 0.5 * a, period_s), behind);
    result.v_rad_s[j] = action == GuardAction::kPassed ? exact : bounds.clamp(own + catching_up);
    result.action = graver(result.action, action);
  }
  return result;
}

}  // namespace

std::string_view id(GuardAction action) {
  switch (action) {
    case GuardAction::kPassed:
      return "passed";
    case GuardAction::kNotFinite:
      return "not_finite";
    case GuardAction::kPosition:
      return "position";
    case GuardAction::kSpeed:
      return "speed";
    case GuardAction::kAcceleration:
      return "acceleration";
    case GuardAction::kToolSpeed:
      return "tool_speed";
  }
  return "unknown";
}

Guarded brakeMotion(const Commanded& last, const Jacobian& jacobian, double period_s,
                    const MotionLimits& limits) noexcept {
  const Cycle cycle(last, jacobian, period_s, limits);
  return {cycle.after(cycle.brakingSpeed()), GuardAction::kPassed};
}

Guarded guardMotion(const Commanded& wish, const Commanded& last, const Jacobian& jacobian, double period_s,
                    const MotionLimits& limits) noexcept {
  assert(period_s > 0.0 && last.q_rad.allFinite() && last.v_rad_s.allFinite());
  const Cycle cycle(last, jacobian, period_s, limits);
  if (!isUsable(wish, cycle.jointCount()))
    return {cycle.after(cycle.brakingSpeed()), GuardAction::kNotFinite};
  const Approach wanted = approach(cycle, wish, last, period_s, limits);
  if (!cycle.toolAllows(wanted.v_rad_s))
    return {cycle.after(cycle.withinTool(wanted.v_rad_s)), graver(wanted.action, GuardAction::kToolSpeed)};
  if (wanted.action == GuardAction::kPassed) return {{wish.q_rad, wanted.v_rad_s}, GuardAction::kPassed};
  return {cycle.after(wanted.v_rad_s), wanted.action};
}

}  // namespace mirrorarm::robot
