#include "core/robot/polynomial.h"

#include <algorithm>

namespace mirrorarm::robot {
namespace {

/// Up to five points in rising order.
struct Points {
  std::array<double, 5> at{};
  int count = 0;
  void add(double t) { at[static_cast<std::size_t>(count++)] = t; }
};

/// The root of `p` between `low` and `high`, where it changes its sign once. Half a millionth of the interval
/// will do: an extreme is flat there.
double rootBetween(const Polynomial& p, double low, double high) {
  const bool rises = valueAt(p, low) < 0.0;
  constexpr int halvings = 22;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (low + high);
    ((valueAt(p, middle) < 0.0) == rises ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// Where `p` changes its sign in [0, duration], given where its derivative does: between two such points it
/// is monotone.
Points signChanges(const Polynomial& p, const Points& turning, double duration) {
  Points changes;
  double low = 0.0;
  for (int i = 0; i <= turning.count; ++i) {
    const double high = i < turning.count ? turning.at[static_cast<std::size_t>(i)] : duration;
    if ((valueAt(p, low) < 0.0) != (valueAt(p, high) < 0.0)) changes.add(rootBetween(p, low, high));
    low = high;
  }
  return changes;
}

Range rangeOver(const Polynomial& p, const Points& turning, double duration) {
  const double first = valueAt(p, 0.0), last = valueAt(p, duration);
  Range range{std::min(first, last), std::max(first, last)};
  for (int i = 0; i < turning.count; ++i) {
    const double value = valueAt(p, turning.at[static_cast<std::size_t>(i)]);
    range = {std::min(range.least, value), std::max(range.most, value)};
  }
  return range;
}

}  // namespace

double valueAt(const Polynomial& p, double t) noexcept {
  return p[0] + t * (p[1] + t * (p[2] + t * (p[3] + t * (p[4] + t * p[5]))));
}

Polynomial derivative(const Polynomial& p) noexcept {
  return {p[1], 2.0 * p[2], 3.0 * p[3], 4.0 * p[4], 5.0 * p[5], 0.0};
}

Polynomial quinticBetween(const EndState& from, const EndState& to, double duration) noexcept {
  const double T = duration, T2 = T * T;
  const double q = to.q - from.q - T * from.v - 0.5 * T2 * from.a;  // what the free cubic part has to add
  const double v = (to.v - from.v - T * from.a) * T;
  const double a = (to.a - from.a) * T2;
  return {from.q,
          from.v,
          0.5 * from.a,
          (10.0 * q - 4.0 * v + 0.5 * a) / (T2 * T),
          (-15.0 * q + 7.0 * v - a) / (T2 * T2),
          (6.0 * q - 3.0 * v + 0.5 * a) / (T2 * T2 * T)};
}

MotionRanges rangesOf(const Polynomial& p, double duration) noexcept {
  const Polynomial speed = derivative(p), acceleration = derivative(speed), jerk = derivative(acceleration);
  const Points jerk_turns = signChanges(derivative(jerk), {}, duration);
  const Points acceleration_turns = signChanges(jerk, jerk_turns, duration);
  const Points speed_turns = signChanges(acceleration, acceleration_turns, duration);
  const Points position_turns = signChanges(speed, speed_turns, duration);
  return {rangeOver(p, position_turns, duration), rangeOver(speed, speed_turns, duration),
          rangeOver(acceleration, acceleration_turns, duration), rangeOver(jerk, jerk_turns, duration)};
}

}  // namespace mirrorarm::robot
