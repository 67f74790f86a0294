#include "core/robot/motion_guard.h"

#include <cassert>
#include <optional>

#include "core/robot/motion_guard_approach.h"
#include "core/robot/motion_guard_check.h"
#include "core/robot/motion_guard_plan.h"

namespace mirrorarm::robot {
namespace {

constexpr int kHalvings = 8;

bool isUsable(const MotionState& wish, Eigen::Index joints) {
  const auto usable = [&](const Joints& numbers) { return numbers.size() == joints && numbers.allFinite(); };
  return usable(wish.q_rad) && usable(wish.v_rad_s) && usable(wish.a_rad_s2);
}

MotionState stateOf(const Commanded& last) { return {last.q_rad, last.v_rad_s, last.a_rad_s2}; }

/// A state, the stop from it, and what stands against it; without a verdict it may be sent.
struct Candidate {
  Commanded command;
  GuardVerdict verdict;
};

/// A state one cycle after `last` with a stop of its own.
Candidate judge(const MotionState& next, const GuardCheck& check) {
  Candidate candidate{{next.q_rad, next.v_rad_s, next.a_rad_s2}, check.step(next)};
  if (!candidate.verdict.passed()) return candidate;
  const ToolMotion tool(check.around().jacobian, next.v_rad_s, next.a_rad_s2, check.period_s());
  for (const Stop& stop : planStops(next, tool, check.period_s(), check.limits())) {
    candidate.command.stop = stop;
    const GuardVerdict verdict = check.stop(next, tool, stop);
    if (verdict.passed()) return {candidate.command, verdict};
    candidate.verdict = graver(candidate.verdict, verdict);
  }
  return candidate;
}

/// One cycle of `stop`.
Commanded follow(const Stop& stop, const GuardCheck& check) {
  const Moment next = StopCourse(stop, check.period_s()).next();
  const Commanded& last = check.last();
  const MotionState state =
      check.next(next.acceleration[0] * last.v_rad_s + next.acceleration[1] * last.a_rad_s2);
  return {state.q_rad, state.v_rad_s, state.a_rad_s2, stop.afterOneCycle()};
}

/// The shortest stop from `last` that keeps the limits of the joints; what is left of its own where none is
/// shorter. Less speed needs no leave of the flange's limits.
Stop shortestStop(const GuardCheck& check) {
  const MotionState start = stateOf(check.last());
  const ToolMotion tool(check.around().jacobian, start.v_rad_s, start.a_rad_s2, 0.0);
  const auto stops = planStops(start, tool, check.period_s(), check.limits());
  Stop shortest = check.last().stop.cycles() > 0 ? check.last().stop : stops[0];
  for (const Stop& stop : stops)
    if (stop.cycles() < shortest.cycles() && check.joints(start, stop).passed()) shortest = stop;
  return shortest;
}

/// The cycle that is always allowed.
Commanded fallBack(const GuardCheck& check) {
  const Commanded& last = check.last();
  if (last.stop.cycles() > 0) return follow(last.stop, check);
  return last.v_rad_s.isZero(0.0) && last.a_rad_s2.isZero(0.0) ? last : follow(shortestStop(check), check);
}

/// The nearest to `wanted` on the way from `allowed` to it that has a stop.
Commanded nearest(const Commanded& allowed, const Joints& wanted_rad_s2, const GuardCheck& check) {
  Commanded best = allowed;
  double least = 0.0, most = 1.0;
  for (int i = 0; i < kHalvings; ++i) {
    const double share = 0.5 * (least + most);
    const Joints a = allowed.a_rad_s2 + share * (wanted_rad_s2 - allowed.a_rad_s2);
    const Candidate candidate = judge(check.next(a), check);
    if (candidate.verdict.passed()) best = candidate.command;
    (candidate.verdict.passed() ? least : most) = share;
  }
  return best;
}

Guarded braked(const GuardCheck& check, GuardAction action) { return {fallBack(check), action}; }

}  // namespace

std::string_view id(GuardAction action) {
  switch (action) {
    case GuardAction::kPassed:
      return "passed";
    case GuardAction::kNotFinite:
      return "not_finite";
    case GuardAction::kFollowingError:
      return "following_error";
    case GuardAction::kPosition:
      return "position";
    case GuardAction::kCollision:
      return "collision";
    case GuardAction::kJerk:
      return "jerk";
    case GuardAction::kAcceleration:
      return "acceleration";
    case GuardAction::kSpeed:
      return "speed";
    case GuardAction::kZoneSpeed:
      return "zone_speed";
    case GuardAction::kToolSpeed:
      return "tool_speed";
    case GuardAction::kToolAcceleration:
      return "tool_acceleration";
  }
  return "unknown";
}

Commanded restAt(const Joints& q_rad) {
  return {q_rad, Joints::Zero(q_rad.size()), Joints::Zero(q_rad.size())};
}

Joints restOf(const Commanded& last, double period_s) noexcept {
  const Share way = StopCourse(last.stop, period_s).atRest().displacement;
  return last.q_rad + way[0] * last.v_rad_s + way[1] * last.a_rad_s2;
}

Guarded brakeMotion(const Commanded& last, const Surroundings& around, double period_s,
                    const MotionLimits& limits) noexcept {
  const GuardCheck check(last, around, period_s, limits);
  if (last.v_rad_s.isZero(0.0) && last.a_rad_s2.isZero(0.0)) return {restAt(last.q_rad)};
  return {follow(shortestStop(check), check)};
}

Guarded guardMotion(const MotionState& wish, const Commanded& last, const Surroundings& around,
                    double period_s, const MotionLimits& limits) noexcept {
  assert(period_s > 0.0 && last.q_rad.allFinite() && last.v_rad_s.allFinite() && last.a_rad_s2.allFinite());
  const GuardCheck check(last, around, period_s, limits);
  if (!isUsable(wish, last.q_rad.size())) return braked(check, GuardAction::kNotFinite);
  if (!(around.following_error_rad <= limits.max_following_error_rad))
    return braked(check, GuardAction::kFollowingError);
  GuardVerdict because;
  if (const auto reached = reach(wish, check)) {
    const Candidate candidate = judge(*reached, check);
    if (candidate.verdict.passed()) return {candidate.command};
    because = candidate.verdict;
  }
  const Approach wanted = approach(wish, check);
  because = graver(because, wanted.because);
  const Candidate candidate = judge(check.next(wanted.a_rad_s2), check);
  if (candidate.verdict.passed()) return {candidate.command, because.action, because.index};
  because = graver(because, candidate.verdict);
  return {nearest(fallBack(check), wanted.a_rad_s2, check), because.action, because.index};
}

}  // namespace mirrorarm::robot
