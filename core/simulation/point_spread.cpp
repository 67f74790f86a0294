#include "core/simulation/point_spread.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mirrorarm::simulation {
namespace {

constexpr double kStepsPerPixel = 1024.0;

double normalShare(double t, double sigma) { return 0.5 * std::erfc(-t / (sigma * std::numbers::sqrt2)); }

/// Integral of normalShare.
double normalRamp(double t, double sigma) {
  const double density = std::exp(-0.5 * t * t / (sigma * sigma)) / std::sqrt(2.0 * std::numbers::pi);
  return t * normalShare(t, sigma) + sigma * density;
}

}  // namespace

PointSpread::PointSpread(double sigma_px) : reach_px_(0.5 + 5.0 * sigma_px) {
  const int steps = static_cast<int>(std::ceil(2.0 * reach_px_ * kStepsPerPixel)) + 2;
  for (int i = 0; i < steps; ++i) {
    const double u = i / kStepsPerPixel - reach_px_;
    line_.push_back(static_cast<float>(normalShare(u + 0.5, sigma_px) - normalShare(u - 0.5, sigma_px)));
    edge_.push_back(static_cast<float>(normalRamp(u + 0.5, sigma_px) - normalRamp(u - 0.5, sigma_px)));
  }
}

float PointSpread::at(const std::vector<float>& table, double u_px) const {
  const double place = (std::clamp(u_px, -reach_px_, reach_px_) + reach_px_) * kStepsPerPixel;
  const auto below = static_cast<std::size_t>(place);
  const float share = static_cast<float>(place - static_cast<double>(below));
  return table[below] + share * (table[below + 1] - table[below]);
}

}  // namespace mirrorarm::simulation
