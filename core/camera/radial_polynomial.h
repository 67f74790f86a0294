#pragma once

#include <array>
#include <optional>

namespace mirrorarm::camera {

/// The odd polynomial r (1 + k1 r^2 + k2 r^4 + k3 r^6 + k4 r^8) that both lens models bend a ray by: `r` is
/// the undistorted radius (brown_conrady) or the angle from the axis (kannala_brandt).
struct RadialPolynomial {
  std::array<double, 4> k{};

  [[nodiscard]] double value(double r) const { return r * gain(r * r); }
  /// value(r) / r, given r squared.
  [[nodiscard]] double gain(double r2) const {
    return 1.0 + r2 * (k[0] + r2 * (k[1] + r2 * (k[2] + r2 * k[3])));
  }
  /// d gain / d(r^2), given r squared.
  [[nodiscard]] double gainSlope(double r2) const {
    return k[0] + r2 * (2.0 * k[1] + r2 * (3.0 * k[2] + r2 * 4.0 * k[3]));
  }
  /// d value / dr.
  [[nodiscard]] double slope(double r) const { return gain(r * r) + 2.0 * r * r * gainSlope(r * r); }

  /// Where the curve turns back: the smallest positive root of its slope; infinity when it never does.
  [[nodiscard]] double turningRadius() const;

  /// The r in [0, largest] with value(r) = `bent` (>= 0); `largest` is at most the turning radius and may be
  /// infinite. Nothing when the curve does not reach so far.
  [[nodiscard]] std::optional<double> inverse(double bent, double largest) const;
};

}  // namespace mirrorarm::camera
