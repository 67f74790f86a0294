#pragma once

#include <algorithm>

namespace mirrorarm::simulation {

/// From 0 to 1 while `x` goes from 0 to 1, with no speed at either end; constant outside.
[[nodiscard]] inline double smoothRamp(double x) {
  x = std::clamp(x, 0.0, 1.0);
  return x * x * (3.0 - 2.0 * x);
}

/// Integral of smoothRamp from 0 to `x`.
[[nodiscard]] inline double smoothRampIntegral(double x) {
  if (x <= 0.0) return 0.0;
  return x >= 1.0 ? x - 0.5 : x * x * x * (1.0 - 0.5 * x);
}

/// From 0 to 1 with minimum jerk: no speed and no acceleration at either end. Source: Flash, Hogan, J.
/// Neuroscience 5(7), 1985.
[[nodiscard]] inline double minimumJerk(double x) {
  x = std::clamp(x, 0.0, 1.0);
  return x * x * x * (10.0 + x * (6.0 * x - 15.0));
}

}  // namespace mirrorarm::simulation
