#include "core/tracking/chance.h"

#include <algorithm>
#include <cmath>

namespace mirrorarm::tracking {
namespace {

double choose(int from, int count) {
  double ways = 1.0;
  for (int i = 0; i < count; ++i) ways *= static_cast<double>(from - i) / (i + 1);
  return ways;
}

}  // namespace

double expectedChanceFits(const Crowd& crowd, int matched) {
  if (matched > crowd.points || matched > crowd.markers) return 0.0;
  const double placements = 1.0 * crowd.points * (crowd.points - 1) * (crowd.points - 2);
  const double triangles = choose(crowd.markers, 3) * placements * std::pow(crowd.pair_rate, 3);
  const double found = 1.0 - std::exp(-crowd.gate_rate);
  return triangles * choose(crowd.markers - 3, matched - 3) * std::pow(found, matched - 3) /
         choose(matched, 3);
}

double pairRateInBall(double distance_m, double width_m, double radius_m) {
  if (!(radius_m > 0.0)) return 1.0;
  const double s = distance_m / radius_m;
  if (s >= 2.0) return 0.0;
  const double density = 3.0 * s * s * (1.0 - 0.75 * s + s * s * s / 16.0) / radius_m;
  return std::min(1.0, 2.0 * width_m * density);
}

}  // namespace mirrorarm::tracking
