#include "core/robot/motion_guard_check.h"

#include <algorithm>
#include <cmath>

namespace mirrorarm::robot {
namespace {

constexpr double kSlack = 1e-6;        // share of a limit that rounding may use up
constexpr double kSpeedAhead = 0.995;  // shares of the flange's limits for what is known to the second order
constexpr double kAccelerationAhead = 0.998;
constexpr double kStep = 0.999;       // the same for the step itself
constexpr double kZoneShare = 0.998;  // of a zone's speed: it falls while the arm comes nearer
constexpr double kWaySlack = 1e-10;   // the same of a way [m, rad]

double of(const Share& share, double v, double a) { return share[0] * v + share[1] * a; }

/// Where the displacement goes during a stop, beside the start at 0.
struct Way {
  double least = 0.0, most = 0.0, end = 0.0;

  Way(const Stop& stop, const StopCourse& course, double period_s, double v, double a)
      : end(of(course.atRest().displacement, v, a)) {
    least = std::min(0.0, end);
    most = std::max(0.0, end);
    if (v * of(course.atPlateau().speed, v, a) >= 0.0) return;
    // It turns round before it brakes: not further on than at its full speed.
    const double on = v * period_s * (stop.release + stop.ramp_in);
    least = std::min(least, on);
    most = std::max(most, on);
  }
};

bool exceeds(double number, double limit) { return std::abs(number) > (1.0 + kSlack) * limit; }

bool isLonger(const Eigen::Vector3d& vector, double limit) {
  return vector.squaredNorm() > (1.0 + 2.0 * kSlack) * limit * limit;
}

/// The top of the speed while the acceleration goes from `from` to `to`: bound from above.
double topSpeed(double v, double from, double to, int cycles, double period_s) {
  if (from * to >= 0.0) return v;
  return v + 0.5 * period_s * cycles * from * std::abs(from / (from - to));
}

}  // namespace

GuardVerdict graver(const GuardVerdict& one, const GuardVerdict& other) {
  if (one.passed()) return other;
  if (other.passed()) return one;
  return one.action <= other.action ? one : other;
}

ToolCap toolCap(const Surroundings& around, const MotionLimits& limits) {
  if (around.zone_speed_m_s < limits.max_tool_speed_m_s)
    return {kZoneShare * around.zone_speed_m_s, GuardAction::kZoneSpeed};
  return {limits.max_tool_speed_m_s, GuardAction::kToolSpeed};
}

double handCap(const Surroundings& around) { return kZoneShare * around.zone_speed_m_s; }

GuardCheck::GuardCheck(const Commanded& last, const Surroundings& around, double period_s,
                       const MotionLimits& limits)
    : last_(last),
      around_(around),
      period_s_(period_s),
      limits_(limits),
      cap_(toolCap(around, limits)),
      tool_curvature_(curvature(around.jacobian, last.v_rad_s, last.v_rad_s)),
      q_rest_(restOf(last, period_s)) {}

MotionState GuardCheck::next(const Joints& a_rad_s2) const {
  const Joints v = last_.v_rad_s + period_s_ * a_rad_s2;
  return {last_.q_rad + period_s_ * v, v, a_rad_s2};
}

GuardVerdict GuardCheck::step(const MotionState& next) const {
  const Eigen::Vector3d curved = curvature(around_.jacobian, next.v_rad_s, next.v_rad_s);
  const Eigen::Vector3d speed = toolOf(around_.jacobian, next.v_rad_s) + 0.5 * period_s_ * curved;
  const Eigen::Vector3d acceleration =
      toolOf(around_.jacobian, next.a_rad_s2) + 0.5 * (curved + tool_curvature_);
  if (isLonger(speed, kStep * cap_.speed_m_s)) return {cap_.action};
  for (const Jacobian& point : around_.hand)
    if (isLonger(toolOf(point, next.v_rad_s) + 0.5 * period_s_ * curvature(point, next.v_rad_s, next.v_rad_s),
                 kStep * handCap(around_)))
      return {GuardAction::kZoneSpeed};
  if (isLonger(acceleration, kStep * limits_.max_tool_acceleration_m_s2))
    return {GuardAction::kToolAcceleration};
  return {};
}

GuardVerdict GuardCheck::stop(const MotionState& start, const ToolMotion& tool_motion,
                              const Stop& stop) const {
  const StopCourse course(stop, period_s_);
  GuardVerdict verdict = joints(start, stop, course);
  if (verdict.passed()) verdict = clearances(start, stop, course);
  if (verdict.passed()) verdict = tool(tool_motion, course);
  return verdict.passed() ? hand(start, course) : verdict;
}

GuardVerdict GuardCheck::joints(const MotionState& start, const Stop& stop, const StopCourse& course) const {
  for (Eigen::Index j = 0; j < start.q_rad.size(); ++j)
    if (const GuardAction action = joint(j, start, stop, course); action != GuardAction::kPassed)
      return {action, static_cast<int>(j)};
  return {};
}

GuardAction GuardCheck::joint(Eigen::Index j, const MotionState& start, const Stop& stop,
                              const StopCourse& course) const {
  const double q = start.q_rad[j], v = start.v_rad_s[j], a = start.a_rad_s2[j];
  const Way way(stop, course, period_s_, v, a);
  if (q + way.most > std::max(limits_.upper_rad[j], last_.q_rad[j]) + kWaySlack ||
      q + way.least < std::min(limits_.lower_rad[j], last_.q_rad[j]) - kWaySlack)
    return GuardAction::kPosition;
  const double released = of(course.released().acceleration, v, a);
  const double plateau = of(course.atRampOut().acceleration, v, a);
  const double step = limits_.max_jerk_rad_s3[j] * period_s_;
  if (exceeds(a - released, step * stop.release) || exceeds(plateau - released, step * stop.ramp_in) ||
      exceeds(plateau, step * stop.ramp_out))
    return GuardAction::kJerk;
  if (exceeds(a, limits_.max_acceleration_rad_s2[j]) || exceeds(plateau, limits_.max_acceleration_rad_s2[j]))
    return GuardAction::kAcceleration;
  const double v_released = of(course.released().speed, v, a);
  const double top = topSpeed(v_released, released, plateau, stop.ramp_in, period_s_);
  if (exceeds(v, limits_.max_speed_rad_s[j]) || exceeds(v_released, limits_.max_speed_rad_s[j]) ||
      exceeds(top, limits_.max_speed_rad_s[j]))
    return GuardAction::kSpeed;
  return GuardAction::kPassed;
}

GuardVerdict GuardCheck::clearances(const MotionState& start, const Stop& stop,
                                    const StopCourse& course) const {
  for (std::size_t i = 0; i < around_.clearances.size(); ++i) {
    const ClearanceRow& row = around_.clearances[i];
    const Way way(stop, course, period_s_, row.gradient.dot(start.v_rad_s), row.gradient.dot(start.a_rad_s2));
    const double change = row.at_rest ? row.gradient.dot(start.q_rad - q_rest_) + way.end
                                      : row.gradient.dot(start.q_rad - last_.q_rad) + way.least;
    if (row.distance_m + change < std::min(row.minimum_m, row.distance_m) - kWaySlack)
      return {GuardAction::kCollision, static_cast<int>(i)};
  }
  return {};
}

GuardVerdict GuardCheck::tool(const ToolMotion& motion, const StopCourse& course) const {
  GuardVerdict verdict;
  static_cast<void>(course.allOf([&](const Moment& moment) {
    if (isLonger(motion.speed(moment), kSpeedAhead * cap_.speed_m_s))
      verdict.action = cap_.action;
    else if (isLonger(motion.acceleration(moment), kAccelerationAhead * limits_.max_tool_acceleration_m_s2))
      verdict.action = GuardAction::kToolAcceleration;
    return verdict.passed();
  }));
  return verdict;
}

GuardVerdict GuardCheck::hand(const MotionState& start, const StopCourse& course) const {
  for (const Jacobian& point : around_.hand) {
    const ToolMotion motion(point, start.v_rad_s, start.a_rad_s2, period_s_);
    const bool kept = course.allOf([&](const Moment& moment) {
      return !isLonger(motion.speed(moment), kSpeedAhead * handCap(around_));
    });
    if (!kept) return {GuardAction::kZoneSpeed};
  }
  return {};
}

}  // namespace mirrorarm::robot
