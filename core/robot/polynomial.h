#pragma once

#include <array>

namespace mirrorarm::robot {

/// Coefficients of a polynomial of degree 5 at most, rising powers.
using Polynomial = std::array<double, 6>;

[[nodiscard]] double valueAt(const Polynomial& p, double t) noexcept;
[[nodiscard]] Polynomial derivative(const Polynomial& p) noexcept;

/// Position, speed and acceleration at one end of a piece.
struct EndState {
  double q = 0.0;
  double v = 0.0;
  double a = 0.0;
};

/// The one quintic that leads from `from` at 0 to `to` at `duration` > 0.
[[nodiscard]] Polynomial quinticBetween(const EndState& from, const EndState& to, double duration) noexcept;

struct Range {
  double least = 0.0;
  double most = 0.0;
};

/// What a polynomial and its first three derivatives take on over a piece.
struct MotionRanges {
  Range position, speed, acceleration, jerk;
};

/// The true extremes over [0, duration]: at the ends and where the next derivative vanishes. Does not
/// allocate.
[[nodiscard]] MotionRanges rangesOf(const Polynomial& p, double duration) noexcept;

}  // namespace mirrorarm::robot
