#include "core/robot/time_optimal.h"

#include <cmath>

namespace mirrorarm::robot {
namespace {

constexpr int kMostSteps = 40;
constexpr double kExact = 1e-11;  // of the position [rad]

EndState afterAll(EndState state, const SpeedChange& change) {
  for (const JerkPiece& piece : change) state = after(state, piece);
  return state;
}

/// The family of motions that change the speed to `even`, then to zero.
class ByEvenSpeed {
 public:
  ByEvenSpeed(const EndState& from, const AxisLimits& limits) : from_(from), limits_(limits) {}

  /// How far one of them comes without a time at even speed.
  [[nodiscard]] double wayOf(double even) const {
    const EndState at_even = afterAll({0.0, from_.v, from_.a}, changeSpeed(from_, even, limits_));
    return afterAll({at_even.q, even, 0.0}, changeSpeed({0.0, even, 0.0}, 0.0, limits_)).q;
  }

  [[nodiscard]] AxisMotion motion(double even, double even_s) const {
    const SpeedChange first = changeSpeed(from_, even, limits_);
    const SpeedChange last = changeSpeed({0.0, even, 0.0}, 0.0, limits_);
    return {{first[0], first[1], first[2], {even_s, 0.0}, last[0], last[1], last[2]}};
  }

 private:
  const EndState& from_;
  const AxisLimits& limits_;
};

/// Where `f` is zero between `low` and `high`, at which it has opposite signs: regula falsi that halves the
/// stale end (Illinois).
template <class Function>
double rootBetween(double low, double f_low, double high, double f_high, Function f) {
  double x = low;
  int side = 0;
  for (int i = 0; i < kMostSteps; ++i) {
    x = (low * f_high - high * f_low) / (f_high - f_low);
    const double value = f(x);
    if (std::abs(value) < kExact) break;
    if ((value < 0.0) == (f_low < 0.0)) {
      low = x;
      f_low = value;
      if (side == -1) f_high /= 2.0;
      side = -1;
    } else {
      high = x;
      f_high = value;
      if (side == 1) f_low /= 2.0;
      side = 1;
    }
  }
  return x;
}

}  // namespace

double AxisMotion::duration() const noexcept {
  double sum = 0.0;
  for (const JerkPiece& piece : pieces) sum += piece.duration_s;
  return sum;
}

AxisMotion toRestAt(double goal, const EndState& from, const AxisLimits& limits) noexcept {
  const ByEvenSpeed family(from, limits);
  const double way = goal - from.q;
  const auto beyond = [&](double even) { return family.wayOf(even) - way; };
  const double at_stop = beyond(0.0);
  if (std::abs(at_stop) < kExact) return family.motion(0.0, 0.0);
  const double fastest = at_stop < 0.0 ? limits.most_speed : limits.least_speed;
  const double at_fastest = beyond(fastest);
  if ((at_fastest < 0.0) == (at_stop < 0.0)) return family.motion(fastest, -at_fastest / fastest);
  // From the coasting speed on, faster means further; below it the way need not grow with the speed.
  const double coasting = coastingSpeed(from, limits.jerk);
  if (coasting / fastest > 0.0 && coasting / fastest < 1.0) {
    const double at_coasting = beyond(coasting);
    if ((at_coasting < 0.0) == (at_stop < 0.0))
      return family.motion(rootBetween(coasting, at_coasting, fastest, at_fastest, beyond), 0.0);
    return family.motion(rootBetween(0.0, at_stop, coasting, at_coasting, beyond), 0.0);
  }
  return family.motion(rootBetween(0.0, at_stop, fastest, at_fastest, beyond), 0.0);
}

}  // namespace mirrorarm::robot
