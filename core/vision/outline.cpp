#include "core/vision/outline.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace mirrorarm::vision {
namespace {

constexpr int kSectors = 16;

/// How far one contour goes around the candidate.
struct Support {
  int contour = -1;
  std::uint32_t sectors = 0;
  double strength = 0.0;  ///< sum of the gradients
  int points = 0;

  [[nodiscard]] int covered() const { return std::popcount(sectors); }
  [[nodiscard]] bool betterThan(const Support& other) const {
    if (covered() != other.covered()) return covered() > other.covered();
    return strength > other.strength;
  }
};

bool pointsInwards(const EdgePoint& point, const Eigen::Vector2f& inside) {
  return point.gradient.dot(inside - point.position_px) > 0.0F;
}

std::uint32_t sectorBit(const Eigen::Vector2f& outwards) {
  const double turn = std::atan2(outwards.y(), outwards.x()) / (2.0 * std::numbers::pi) + 0.5;
  return 1U << std::clamp(static_cast<int>(turn * kSectors), 0, kSectors - 1);
}

Support supportOf(std::span<const EdgePoint> edges, int contour, const Eigen::Vector2f& inside) {
  Support support{contour};
  for (const auto& point : edges) {
    if (point.contour != contour || !pointsInwards(point, inside)) continue;
    support.sectors |= sectorBit(point.position_px - inside);
    support.strength += point.gradient.norm();
    ++support.points;
  }
  return support;
}

}  // namespace

void selectOutline(std::span<const EdgePoint> edges, const Eigen::Vector2d& inside, float least_gradient,
                   std::vector<EdgePoint>& outline) {
  outline.clear();
  const Eigen::Vector2f centre = inside.cast<float>();
  Support best;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const int contour = edges[i].contour;
    const bool seen = std::any_of(edges.begin(), edges.begin() + static_cast<std::ptrdiff_t>(i),
                                  [&](const EdgePoint& point) { return point.contour == contour; });
    if (seen) continue;
    const auto support = supportOf(edges, contour, centre);
    if (support.betterThan(best)) best = support;
  }
  if (best.covered() < kSectors / 2 || best.strength < least_gradient * best.points) return;
  for (const auto& point : edges)
    if (point.contour == best.contour && pointsInwards(point, centre)) outline.push_back(point);
}

}  // namespace mirrorarm::vision
