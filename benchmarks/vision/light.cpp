#include "benchmarks/vision/light.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mirrorarm::benchmarks::vision {
namespace {

/// A Gaussian point spread averaged over a pixel: its density along one axis, and the integrals from minus
/// infinity to t of the density and of t times the density.
class Spread {
 public:
  explicit Spread(double sigma) : sigma_(sigma) {}

  [[nodiscard]] double reach() const { return 0.5 + 7.0 * sigma_; }
  [[nodiscard]] double density(double t) const { return normalShare(t + 0.5) - normalShare(t - 0.5); }
  [[nodiscard]] double integral(double t) const { return ramp(t + 0.5) - ramp(t - 0.5); }
  [[nodiscard]] double moment(double t) const {
    return parabola(t + 0.5) - parabola(t - 0.5) - 0.5 * (ramp(t + 0.5) + ramp(t - 0.5));
  }

 private:
  [[nodiscard]] double normalShare(double t) const {
    return 0.5 * std::erfc(-t / (sigma_ * std::numbers::sqrt2));
  }
  [[nodiscard]] double normalDensity(double t) const {
    return std::exp(-0.5 * t * t / (sigma_ * sigma_)) / std::sqrt(2.0 * std::numbers::pi);
  }
  /// Integral of normalShare.
  [[nodiscard]] double ramp(double t) const { return t * normalShare(t) + sigma_ * normalDensity(t); }
  /// Integral of t * normalShare(t).
  [[nodiscard]] double parabola(double t) const {
    return 0.5 * ((t * t - sigma_ * sigma_) * normalShare(t) + sigma_ * t * normalDensity(t));
  }

  double sigma_;
};

struct Columns {
  int first = 0, past = 0;
};

/// Pixels 0 .. size - 1 between the outline's ends and as far as the spread reaches.
Columns columnsOf(const Outline& outline, double reach, int width) {
  const auto [left, right] =
      std::minmax_element(outline.begin(), outline.end(), [](auto& a, auto& b) { return a.x < b.x; });
  return {std::clamp(static_cast<int>(std::floor(left->x - reach)), 0, width),
          std::clamp(static_cast<int>(std::ceil(right->x + reach)) + 1, 0, width)};
}

/// Antiderivative along x of shading times spread for each column, at one node.
void fillColumns(const OutlineNode& node, const Columns& columns, const Spread& spread,
                 const Shading& shading, std::vector<double>& values) {
  const double at_row = 1.0 + shading.slope.y() * (node.y - shading.origin.y());
  for (int x = columns.first; x < columns.past; ++x) {
    const double t = node.x - x;
    double& value = values[static_cast<std::size_t>(x)];
    const double here = at_row + shading.slope.x() * (x - shading.origin.x());
    if (t > spread.reach())
      value = here;
    else if (t < -spread.reach())
      value = 0.0;
    else
      value = here * spread.integral(t) + shading.slope.x() * spread.moment(t);
  }
}

}  // namespace

void addSurface(Light& light, const Outline& outline, double spread_px, const Shading& shading) {
  const Spread spread(spread_px);
  const Columns columns = columnsOf(outline, spread.reach(), light.width_px);
  std::vector<double> values(static_cast<std::size_t>(light.width_px));
  for (const OutlineNode& node : outline) {
    fillColumns(node, columns, spread, shading, values);
    const int top = std::max(0, static_cast<int>(std::ceil(node.y - spread.reach())));
    const int last = std::min(light.height_px - 1, static_cast<int>(std::floor(node.y + spread.reach())));
    for (int y = top; y <= last; ++y) {
      const double weight = shading.level * node.dy * spread.density(y - node.y);
      for (int x = columns.first; x < columns.past; ++x)
        light.at(x, y) += weight * values[static_cast<std::size_t>(x)];
    }
  }
}

camera::GreyImage exposed(const Light& light, double sigma, TrialRandom& random) {
  std::vector<std::uint8_t> pixels(light.grey.size());
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const double noise = sigma > 0.0 ? sigma * random.normal() : 0.0;
    pixels[i] = static_cast<std::uint8_t>(std::clamp(std::round(light.grey[i] + noise), 0.0, 255.0));
  }
  return {light.width_px, light.height_px, std::move(pixels)};
}

}  // namespace mirrorarm::benchmarks::vision
