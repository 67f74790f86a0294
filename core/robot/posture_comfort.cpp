#include "core/robot/posture_comfort.h"

#include <algorithm>
#include <cmath>

namespace mirrorarm::robot {
namespace {

constexpr double kNearEnd = 0.999;   // of half a range; beyond, the slope grows no more
constexpr double kBentSine = 0.342;  // of 20 degrees
constexpr double kSmallestSine = 1e-4;
constexpr double kStride_rad = 0.1;  // narrower than any barrier of discomfort
constexpr double kResolution_rad = 1e-10;
constexpr int kMaxRounds = 60;

/// Of x^2 / (1 - x^2), x from -1 to 1 over the range.
double endSlope(double q, double lower, double upper) {
  const double half = 0.5 * (upper - lower);
  const double x = std::clamp((q - 0.5 * (lower + upper)) / half, -kNearEnd, kNearEnd);
  const double left = 1.0 - x * x;
  return 2.0 * x / (left * left) / half;
}

/// Of (u - 1)^2 where u = (kBentSine / sin q)^2 is above one.
double alignedSlope(double q) {
  const double sine = std::copysign(std::max(std::abs(std::sin(q)), kSmallestSine), std::sin(q));
  const double u = (kBentSine / sine) * (kBentSine / sine);
  return u > 1.0 ? -4.0 * (u - 1.0) * u * std::cos(q) / sine : 0.0;
}

}  // namespace

double discomfortSlope(const SrsPostures& postures, const JointRanges& ranges, const Joints& q) {
  const Joints rates = postures.rates(q);
  double slope = alignedSlope(q[1]) * rates[1] + alignedSlope(q[5]) * rates[5];
  for (int i = 0; i < kSrsJoints; ++i) slope += endSlope(q[i], ranges.lower[i], ranges.upper[i]) * rates[i];
  return slope;
}

double comfortableArmAngle(const SrsPostures& postures, const JointRanges& ranges, int branch,
                           double arm_angle, double reach) {
  const auto slopeAt = [&](double psi) {
    return discomfortSlope(postures, ranges, postures.posture(psi, branch));
  };
  double here = arm_angle, slope = slopeAt(here);
  if (slope == 0.0) return here;
  const double downhill = slope > 0.0 ? -1.0 : 1.0;
  const double end = arm_angle + downhill * reach;
  double next = here, next_slope = slope;
  while (next != end && slope * next_slope > 0.0) {
    here = next;
    slope = next_slope;
    next = downhill > 0.0 ? std::min(here + kStride_rad, end) : std::max(here - kStride_rad, end);
    next_slope = slopeAt(next);
  }
  if (slope * next_slope > 0.0) return end;
  // Regula falsi with the Illinois rule: the valley lies between `here` and `next`.
  double weight_here = slope, weight_next = next_slope;
  int last_side = 0;
  for (int round = 0; round < kMaxRounds && std::abs(next - here) > kResolution_rad; ++round) {
    const double middle = (here * weight_next - next * weight_here) / (weight_next - weight_here);
    const double found = slopeAt(middle);
    if (found == 0.0) return middle;
    if (found * slope > 0.0) {
      here = middle;
      weight_here = found;
      if (last_side == -1) weight_next *= 0.5;
      last_side = -1;
    } else {
      next = middle;
      weight_next = found;
      if (last_side == 1) weight_here *= 0.5;
      last_side = 1;
    }
  }
  return 0.5 * (here + next);
}

}  // namespace mirrorarm::robot
