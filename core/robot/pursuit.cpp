#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/robot/time_optimal.h"
#include "core/robot/trajectory.h"

namespace mirrorarm::robot {
namespace {

constexpr double kFastestGoal = 0.95;  // of a joint's speed: there must be some left to catch up with
constexpr double kSlack = 1e-9;

/// Larger of the magnitudes at both ends of [0, duration] and at the turning points inside.
double largestOf(const Polynomial& p, double duration, std::initializer_list<double> turns) {
  double largest = std::max(std::abs(valueAt(p, 0.0)), std::abs(valueAt(p, duration)));
  for (const double t : turns)
    if (t > 0.0 && t < duration) largest = std::max(largest, std::abs(valueAt(p, t)));
  return largest;
}

/// Range that a quartic does not leave over [0, duration]: that of its control points (Bernstein form).
Range hullOf(const Polynomial& p, double duration) {
  constexpr std::array<std::array<double, 5>, 5> kShares = {{{1.0, 0.0, 0.0, 0.0, 0.0},
                                                             {1.0, 1.0 / 4.0, 0.0, 0.0, 0.0},
                                                             {1.0, 1.0 / 2.0, 1.0 / 6.0, 0.0, 0.0},
                                                             {1.0, 3.0 / 4.0, 1.0 / 2.0, 1.0 / 4.0, 0.0},
                                                             {1.0, 1.0, 1.0, 1.0, 1.0}}};
  Range hull{p[0], p[0]};
  for (const auto& shares : kShares) {
    double point = 0.0, power = 1.0;
    for (std::size_t i = 0; i < shares.size(); ++i, power *= duration) point += shares[i] * p[i] * power;
    hull = {std::min(hull.least, point), std::max(hull.most, point)};
  }
  return hull;
}

/// Whether a quintic keeps the limits, for sure: one whose control points of the speed leave them is refused,
/// although the speed itself may not.
bool surelyKeeps(const Polynomial& quintic, double duration_s, const AxisLimits& limits) {
  const Polynomial speed = derivative(quintic), acceleration = derivative(speed),
                   jerk = derivative(acceleration);
  const double vertex = -jerk[1] / (2.0 * jerk[2]);
  if (!(largestOf(jerk, duration_s, {vertex}) <= limits.jerk + kSlack)) return false;
  const double spread = std::sqrt(std::max(0.0, vertex * vertex - jerk[0] / jerk[2]));
  if (!(largestOf(acceleration, duration_s, {vertex - spread, vertex + spread}) <=
        limits.acceleration + kSlack))
    return false;
  const Range hull = hullOf(speed, duration_s);
  return hull.least >= limits.least_speed - kSlack && hull.most <= limits.most_speed + kSlack;
}

Polynomial cubic(const EndState& from, double jerk) { return {from.q, from.v, from.a / 2.0, jerk / 6.0}; }

}  // namespace

/// One joint's way onto its goal. Relative positions and speeds are as seen from the moving goal.
class Trajectory::Pursuit {
 public:
  Pursuit() = default;
  Pursuit(const EndState& from, double goal, double goal_speed, const AxisLimits& limits)
      : goal_(goal),
        goal_speed_(goal_speed),
        own_limits_(limits),
        limits_{limits.least_speed - goal_speed, limits.most_speed - goal_speed, limits.acceleration,
                limits.jerk},
        from_{from.q - goal, from.v - goal_speed, from.a},
        fastest_(toRestAt(0.0, from_, limits_)) {}

  [[nodiscard]] double leastTime() const { return fastest_.duration(); }

  /// Appends the pursuit that takes about `catch_up_s`, cut off at `horizon_s` where the goal moves.
  void appendTo(JointMotion& joint, double catch_up_s, double horizon_s) const {
    const bool moves = goal_speed_ != 0.0;
    const double until = moves ? horizon_s : std::max(catch_up_s, leastTime());
    double t = 0.0;
    EndState state = from_;
    if (const auto smooth = quinticBetween(from_, {}, catch_up_s);
        leastTime() < catch_up_s && surelyKeeps(smooth, catch_up_s, limits_)) {
      t = std::min(catch_up_s, until);
      state = append(joint, 0.0, t, smooth);
    } else {
      for (const JerkPiece& piece : fastest_.pieces) {
        const double lasts = std::min(piece.duration_s, until - t);
        if (!(lasts > 0.0)) continue;
        state = append(joint, t, lasts, cubic(state, piece.jerk));
        t += lasts;
      }
    }
    if (!moves) return joint.append(0.0, {goal_});
    if (t < until) state = append(joint, t, until - t, cubic(state, 0.0));
    stop(joint, {state.q + goal_ + goal_speed_ * until, state.v + goal_speed_, state.a});
  }

 private:
  /// Appends a piece that begins at `t`; gives the relative state at its end.
  EndState append(JointMotion& joint, double t, double lasts, const Polynomial& relative) const {
    Polynomial absolute = relative;
    absolute[0] += goal_ + goal_speed_ * t;
    absolute[1] += goal_speed_;
    joint.append(lasts, absolute);
    const Polynomial speed = derivative(relative);
    return {valueAt(relative, lasts), valueAt(speed, lasts), valueAt(derivative(speed), lasts)};
  }

  void stop(JointMotion& joint, EndState state) const {
    for (const JerkPiece& piece : changeSpeed(state, 0.0, own_limits_)) {
      if (!(piece.duration_s > 0.0)) continue;
      joint.append(piece.duration_s, cubic(state, piece.jerk));
      state = after(state, piece);
    }
    if (joint.piece_count == 0) joint.append(0.0, {state.q});
  }

  double goal_ = 0.0, goal_speed_ = 0.0;
  AxisLimits own_limits_, limits_;
  EndState from_;
  AxisMotion fastest_;
};

namespace {

/// How fast the goal of a joint is taken to move: not faster than the joint can follow, nor out of its range.
double believedSpeed(double goal, double speed, Eigen::Index j, const MotionLimits& limits,
                     double horizon_s) {
  const double most = kFastestGoal * limits.max_speed_rad_s[j];
  const double room = std::max(0.0, speed > 0.0 ? limits.upper_rad[j] - goal : goal - limits.lower_rad[j]);
  const double within_range = room / (horizon_s + most / limits.max_acceleration_rad_s2[j]);
  const double bound = std::min(most, within_range);
  return std::clamp(speed, -bound, bound);
}

}  // namespace

Trajectory Trajectory::pursuit(const MotionState& from, const MovingGoal& goal, TimePoint start,
                               const MotionLimits& limits, const PursuitTimes& times) {
  const Eigen::Index n = from.q_rad.size();
  assert(goal.q_rad.size() == n && goal.v_rad_s.size() == n);
  std::array<Pursuit, kMaxJoints> joints;
  double catch_up_s = times.catch_up.count();
  for (Eigen::Index j = 0; j < n; ++j) {
    const double most = limits.max_speed_rad_s[j];
    Pursuit& joint = joints[static_cast<std::size_t>(j)];
    joint = {{from.q_rad[j], from.v_rad_s[j], from.a_rad_s2[j]},
             goal.q_rad[j],
             believedSpeed(goal.q_rad[j], goal.v_rad_s[j], j, limits, times.horizon.count()),
             {-most, most, limits.max_acceleration_rad_s2[j], limits.max_jerk_rad_s3[j]}};
    catch_up_s = std::max(catch_up_s, joint.leastTime());
  }
  Trajectory trajectory(n, start);
  for (Eigen::Index j = 0; j < n; ++j)
    joints[static_cast<std::size_t>(j)].appendTo(trajectory.joint(j), catch_up_s, times.horizon.count());
  return trajectory;
}

}  // namespace mirrorarm::robot
