#include "core/experiments/held_moves.h"

#include <algorithm>
#include <random>

#include "core/simulation/smooth_ramp.h"

namespace mirrorarm::experiments {
namespace {

constexpr double kLength_m = 0.10;
constexpr double kMinimumJerk_s = 2.0;                          // peak 0.094 m/s and 0.144 m/s^2
constexpr double kSpeed_m_s = 0.10, kAcceleration_m_s2 = 0.30;  // of the trapezoid
constexpr double kShortestRest_s = 1.0, kLongestRest_s = 1.5;

double trapezoid(double length_m, double t) {
  const double ramp_s = kSpeed_m_s / kAcceleration_m_s2;
  const double duration = length_m / kSpeed_m_s + ramp_s;
  if (t <= 0.0) return 0.0;
  if (t >= duration) return length_m;
  if (t < ramp_s) return 0.5 * kAcceleration_m_s2 * t * t;
  if (t < duration - ramp_s) return kSpeed_m_s * (t - 0.5 * ramp_s);
  return length_m - 0.5 * kAcceleration_m_s2 * (duration - t) * (duration - t);
}

}  // namespace

std::string_view id(MoveProfile profile) {
  return profile == MoveProfile::kMinimumJerk ? "minimum_jerk" : "trapezoid";
}

double HeldMove::wayAt(double time_s) const {
  const double t = time_s - start_s;
  if (profile == MoveProfile::kTrapezoid) return trapezoid(shift_m.norm(), t);
  return shift_m.norm() * simulation::minimumJerk(std::clamp(t / kMinimumJerk_s, 0.0, 1.0));
}

double HeldMove::duration_s() const {
  return profile == MoveProfile::kMinimumJerk ? kMinimumJerk_s
                                              : shift_m.norm() / kSpeed_m_s + kSpeed_m_s / kAcceleration_m_s2;
}

std::vector<HeldMove> movesToAndFro(MoveProfile profile, int count, double first_start_s, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> rest(kShortestRest_s, kLongestRest_s);
  std::vector<HeldMove> moves;
  double start_s = first_start_s;
  for (int i = 0; i < count; ++i) {
    const int axis = 1 + (i / 4) % 2;
    const double side = i % 4 < 2 ? 1.0 : -1.0;
    const double back = i % 2 == 0 ? 1.0 : -1.0;
    moves.push_back({start_s, side * back * kLength_m * Eigen::Vector3d::Unit(axis), profile});
    start_s = moves.back().end_s() + rest(random);
  }
  return moves;
}

Eigen::Vector3d shiftAt(const std::vector<HeldMove>& moves, double time_s) {
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
  for (const HeldMove& move : moves) shift += move.wayAt(time_s) * move.shift_m.normalized();
  return shift;
}

}  // namespace mirrorarm::experiments
