#include "benchmarks/tracking/nearest_neighbour_icp.h"

#include <algorithm>

#include "core/geometry/rigid_fit.h"

namespace mirrorarm::benchmarks::tracking {
namespace {

using Eigen::Vector3d;
using Points = std::span<const Vector3d>;

constexpr int kMostRounds = 50;
constexpr double kKeptShare = 0.8;

struct Pair {
  double distance_m = 0.0;
  int x = 0;
  int y = 0;
};

/// Of every model point the nearest cloud point, nearest pairs first.
std::vector<Pair> nearestPairs(Points x, Points y, const RigidTransform& X_YX) {
  std::vector<Pair> pairs;
  for (int i = 0; i < static_cast<int>(x.size()); ++i) {
    const Vector3d moved = X_YX * x[static_cast<std::size_t>(i)];
    const auto distance = [&](const Vector3d& p) { return (p - moved).norm(); };
    const auto nearest = std::ranges::min_element(y, {}, distance);
    pairs.push_back({distance(*nearest), i, static_cast<int>(nearest - y.begin())});
  }
  std::ranges::sort(pairs, {}, &Pair::distance_m);
  return pairs;
}

RigidTransform fit(Points x, Points y, std::span<const Pair> pairs) {
  std::vector<Vector3d> from, to;
  for (const Pair& pair : pairs) {
    from.push_back(x[static_cast<std::size_t>(pair.x)]);
    to.push_back(y[static_cast<std::size_t>(pair.y)]);
  }
  return fitByKabsch(from, to);
}

bool areAlike(const std::vector<Pair>& a, const std::vector<Pair>& b) {
  return std::ranges::equal(a, b, [](const Pair& p, const Pair& q) { return p.x == q.x && p.y == q.y; });
}

}  // namespace

IcpResult nearestNeighbourIcp(Points x, Points y, double gate_m) {
  IcpResult result;
  result.X_YX.translation() = centroid(y) - centroid(x);
  const auto kept = static_cast<std::size_t>(kKeptShare * static_cast<double>(x.size()));
  std::vector<Pair> pairs, before;
  for (int round = 0; round < kMostRounds; ++round) {
    pairs = nearestPairs(x, y, result.X_YX);
    if (areAlike(pairs, before)) break;
    result.X_YX = fit(x, y, std::span(pairs).first(kept));
    before = pairs;
  }
  result.y_of_x.assign(x.size(), -1);
  std::vector<char> taken(y.size(), 0);
  for (const Pair& pair : pairs) {
    if (pair.distance_m > gate_m || taken[static_cast<std::size_t>(pair.y)] != 0) continue;
    taken[static_cast<std::size_t>(pair.y)] = 1;
    result.y_of_x[static_cast<std::size_t>(pair.x)] = pair.y;
  }
  return result;
}

}  // namespace mirrorarm::benchmarks::tracking
