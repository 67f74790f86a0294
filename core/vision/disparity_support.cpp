#include "core/vision/disparity_support.h"

#include <algorithm>
#include <cmath>

namespace mirrorarm::vision {
namespace {

constexpr double kLeastSeparation_px = 1.0;
constexpr double kRounding = 1e-9;

bool areRivals(const StereoPoint& a, const StereoPoint& b) { return a.left == b.left || a.right == b.right; }

double supportBetween(const RectifiedPair& a, const RectifiedPair& b, double max_gradient) {
  const double separation_px = (a.cyclopean_px - b.cyclopean_px).norm();
  if (std::abs(a.disparity_px - b.disparity_px) > max_gradient * separation_px) return 0.0;
  return 1.0 / std::max(separation_px, kLeastSeparation_px);
}

}  // namespace

void fillSupport(std::span<const RectifiedPair> pairs, double max_disparity_gradient,
                 std::span<StereoPoint> points) {
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      if (areRivals(points[i], points[j])) continue;
      const double support = supportBetween(pairs[i], pairs[j], max_disparity_gradient);
      points[i].support += support;
      points[j].support += support;
    }
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      if (!areRivals(points[i], points[j])) continue;
      ++points[i].rivals;
      ++points[j].rivals;
      const double more = points[i].support - points[j].support;
      const bool first_is_better =
          std::abs(more) > kRounding ? more > 0.0 : pairs[i].misfit <= pairs[j].misfit;
      (first_is_better ? points[j] : points[i]).preferred = false;
    }
}

}  // namespace mirrorarm::vision
