#include "core/robot/motion_guard_approach.h"

#include <algorithm>
#include <cmath>

namespace mirrorarm::robot {
namespace {

constexpr double kSlack = 1e-6;            // share of a limit that rounding may use up
constexpr double kSameSpeed = 0.5;         // of what the jerk changes in two cycles
constexpr double kSameAcceleration = 1.5;  // of what the jerk changes in a cycle
constexpr double kSpeedGain_hz = 50.0;     // from a missing speed to an acceleration
constexpr double kMostGain = 0.3;          // of a missing speed in one cycle
constexpr double kPositionGain = 0.24;     // of the other gain: below a quarter nothing overshoots
constexpr double kBraking = 0.5;           // share of the acceleration with which a wish is approached
constexpr double kClearanceGain_hz = 4.0;  // from a gap to the speed towards it
constexpr double kRestGain_hz = 10.0;      // the same for the gap that a stop leaves
constexpr int kClearanceRounds = 2;
constexpr double kSpeedShare = 0.99;
constexpr double kToolSpeedShare = 0.98;
constexpr double kAccelerationShare = 0.995;
constexpr double kToolAccelerationShare = 0.97;

double within(double number, double limit) { return std::clamp(number, -limit, limit); }

/// Speed towards something `way` off: evenly falling near it, further away as fast as one can brake from.
double approachSpeed(double way, double gain_hz, double braking) {
  const double even = braking / (gain_hz * gain_hz), off = std::abs(way);
  if (off <= even) return gain_hz * way;
  return std::copysign(std::sqrt(2.0 * braking * (off - 0.5 * even)), way);
}

/// The largest share of 1 for which |from + share * along| <= radius; 0 when there is none.
double reachOf(const Eigen::Vector3d& from, const Eigen::Vector3d& along, double radius) {
  const double aa = along.squaredNorm(), ab = along.dot(from), c = from.squaredNorm() - radius * radius;
  const double discriminant = ab * ab - aa * c;
  if (c > 0.0 || !(discriminant >= 0.0)) return 0.0;
  if (aa <= 0.0) return 1.0;
  return std::clamp((std::sqrt(discriminant) - ab) / aa, 0.0, 1.0);
}

class Shaper {
 public:
  Shaper(const MotionState& wish, const GuardCheck& check)
      : wish_(wish),
        check_(check),
        limits_(check.limits()),
        gain_hz_(std::min(kSpeedGain_hz, kMostGain / check.period_s())),
        v_(wish.q_rad.size()),
        a_(wish.q_rad.size()) {}

  Approach run() {
    for (Eigen::Index j = 0; j < v_.size(); ++j) wantSpeed(j);
    for (int round = 0; round < kClearanceRounds; ++round) keepClear();
    slowDown();
    for (Eigen::Index j = 0; j < a_.size(); ++j) wantAcceleration(j);
    spareTool();
    for (Eigen::Index j = 0; j < a_.size(); ++j) limitJerk(j);
    if (because_.passed()) because_ = {GuardAction::kJerk};  // only a jump could reach the wish now
    return {a_, because_};
  }

 private:
  void blame(GuardAction action, Eigen::Index index = -1) {
    because_ = graver(because_, {action, static_cast<int>(index)});
  }

  void wantSpeed(Eigen::Index j) {
    const double wished = wish_.q_rad[j], q = std::clamp(wished, limits_.lower_rad[j], limits_.upper_rad[j]);
    const double most = kSpeedShare * limits_.max_speed_rad_s[j];
    if (q != wished) blame(GuardAction::kPosition, j);
    const double own = q == wished ? within(wish_.v_rad_s[j], most) : 0.0;
    const double behind = q - own * check_.period_s() - check_.last().q_rad[j];
    const double braking = kBraking * limits_.max_acceleration_rad_s2[j];
    const double gain_hz = kPositionGain * gain_hz_;
    const double v = own + approachSpeed(behind, gain_hz, braking);
    const double near = std::max(0.0, 1.0 - std::abs(behind) * gain_hz * gain_hz / braking);
    v_[j] = within(v, most);
    a_[j] = q == wished ? near * within(wish_.a_rad_s2[j], limits_.max_acceleration_rad_s2[j]) : 0.0;
    if (v_[j] != v) blame(GuardAction::kSpeed, j);
  }

  /// Takes away of the speed what goes towards a thing too fast; what goes along it stays.
  void keepClear() {
    const auto rows = check_.around().clearances;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const double room = std::max(0.0, rows[i].distance_m - rows[i].minimum_m);
      const double allowed = -(rows[i].at_rest ? kRestGain_hz : kClearanceGain_hz) * room;
      const double too_fast = allowed - rows[i].gradient.dot(v_);
      const double size = rows[i].gradient.squaredNorm();
      if (!(too_fast > 0.0) || !(size > 0.0)) continue;
      v_ += too_fast / size * rows[i].gradient;
      blame(GuardAction::kCollision, static_cast<Eigen::Index>(i));
    }
  }

  void slowDown() {
    double share = 1.0;
    for (Eigen::Index j = 0; j < v_.size(); ++j)
      share = std::min(share, shareOf(std::abs(v_[j]), kSpeedShare * limits_.max_speed_rad_s[j]));
    v_ *= share;
    const ToolCap cap = toolCap(check_.around(), limits_);
    keepBelow(check_.around().jacobian, cap.speed_m_s, cap.action);
    for (const Jacobian& point : check_.around().hand)
      keepBelow(point, handCap(check_.around()), GuardAction::kZoneSpeed);
  }
  void keepBelow(const Jacobian& point, double cap_m_s, GuardAction action) {
    const double speed = toolOf(point, v_).norm();
    if (speed <= kToolSpeedShare * cap_m_s) return;
    v_ *= kToolSpeedShare * cap_m_s / speed;
    blame(action);
  }
  [[nodiscard]] static double shareOf(double number, double limit) {
    return number > limit ? limit / number : 1.0;
  }

  void wantAcceleration(Eigen::Index j) {
    const double a = a_[j] + gain_hz_ * (v_[j] - check_.last().v_rad_s[j]);
    a_[j] = within(a, kAccelerationShare * limits_.max_acceleration_rad_s2[j]);
    if (a_[j] != a) blame(GuardAction::kAcceleration, j);
  }

  void spareTool() {
    const double share = reachOf(check_.toolCurvature(), toolOf(check_.around().jacobian, a_),
                                 kToolAccelerationShare * limits_.max_tool_acceleration_m_s2);
    if (share >= 1.0) return;
    a_ *= share;
    blame(GuardAction::kToolAcceleration);
  }

  void limitJerk(Eigen::Index j) {
    const double step = limits_.max_jerk_rad_s3[j] * check_.period_s(), last = check_.last().a_rad_s2[j];
    const double a = std::clamp(a_[j], last - step, last + step);
    if (a != a_[j]) blame(GuardAction::kJerk, j);
    a_[j] = a;
  }

  const MotionState& wish_;
  const GuardCheck& check_;
  const MotionLimits& limits_;
  double gain_hz_;
  Joints v_, a_;
  GuardVerdict because_;
};

bool fits(double number, double limit) { return std::abs(number) <= (1.0 + kSlack) * limit; }

}  // namespace

std::optional<MotionState> reach(const MotionState& wish, const GuardCheck& check) {
  const double period_s = check.period_s();
  const MotionLimits& limits = check.limits();
  const Joints v = (wish.q_rad - check.last().q_rad) / period_s;
  const Joints a = (v - check.last().v_rad_s) / period_s;
  for (Eigen::Index j = 0; j < v.size(); ++j) {
    const double step = limits.max_jerk_rad_s3[j] * period_s;
    // The wire's speed is the mean of the cycle.
    const double own = wish.v_rad_s[j] - 0.5 * period_s * wish.a_rad_s2[j];
    if (!fits(v[j], limits.max_speed_rad_s[j]) || !fits(a[j], limits.max_acceleration_rad_s2[j]) ||
        !fits(a[j] - check.last().a_rad_s2[j], step) || !fits(v[j] - own, kSameSpeed * step * period_s) ||
        !fits(a[j] - wish.a_rad_s2[j], kSameAcceleration * step))
      return std::nullopt;
  }
  return MotionState{wish.q_rad, v, a};
}

Approach approach(const MotionState& wish, const GuardCheck& check) { return Shaper(wish, check).run(); }

}  // namespace mirrorarm::robot
