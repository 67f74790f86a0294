#include "core/camera/radial_polynomial.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Eigenvalues>

namespace mirrorarm::camera {

double RadialPolynomial::turningRadius() const {
  // In u = 1/r^2 the slope is u^4 + 3 k1 u^3 + 5 k2 u^2 + 7 k3 u + 9 k4: always of full degree, so that
  // unused terms only put roots at u = 0, which is r = infinity.
  Eigen::Matrix4d companion = Eigen::Matrix4d::Zero();
  for (int i = 0; i < 4; ++i) companion(0, i) = -(2.0 * i + 3.0) * k[static_cast<std::size_t>(i)];
  companion.diagonal(-1).setOnes();
  const Eigen::Vector4cd roots = companion.eigenvalues();
  double u = 0.0;
  for (const auto& root : roots)
    if (std::abs(root.imag()) <= 1e-9 * std::abs(root)) u = std::max(u, root.real());
  return u > 1e-12 ? 1.0 / std::sqrt(u) : std::numeric_limits<double>::infinity();
}

std::optional<double> RadialPolynomial::inverse(double bent, double largest) const {
  double low = 0.0;
  double high = std::min(largest, std::max(bent, 1e-3));
  while (value(high) < bent && high < largest) high = std::min(2.0 * high, largest);
  if (!(value(high) >= bent)) return std::nullopt;
  double r = std::min(bent, high);
  for (int i = 0; i < 100; ++i) {
    const double error = value(r) - bent;
    (error > 0.0 ? high : low) = r;
    double next = r - error / slope(r);
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (std::abs(next - r) <= 1e-15 * std::max(1.0, r)) return next;
    r = next;
  }
  return r;
}

}  // namespace mirrorarm::camera
