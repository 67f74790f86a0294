#include "core/robot/path_shortening.h"

#include <algorithm>
#include <cmath>

namespace mirrorarm::robot {
namespace {

constexpr int kRounds = 4;
constexpr int kPulls = 2;   // each with twice as many corners as the one before
constexpr int kSweeps = 6;  // over the corners
constexpr double kLeastPull = 0.1;
constexpr double kLongestEdge_rad = 0.3;
constexpr double kLonger = 1.5;  // than before, where there would be too many

/// Leaves out what lies between two states that see each other, farthest first, until nothing more can go.
std::vector<Joints> withoutDetours(const std::vector<Joints>& path, const Passable& passable) {
  std::vector<Joints> kept = {path.front()};
  for (std::size_t i = 0; i + 1 < path.size();) {
    std::size_t next = path.size() - 1;
    while (next > i + 1 && !passable.along(path[i], path[next])) --next;
    kept.push_back(path[next]);
    i = next;
  }
  return kept;
}

std::vector<Joints> withMiddles(const std::vector<Joints>& path) {
  std::vector<Joints> more = {path.front()};
  for (std::size_t i = 1; i < path.size(); ++i) {
    more.push_back(0.5 * (path[i - 1] + path[i]));
    more.push_back(path[i]);
  }
  return more;
}

/// Moves each corner towards the middle of its neighbours, as far as halving finds it passable: what a rubber
/// band would do.
void pullTight(std::vector<Joints>& path, const Passable& passable) {
  for (int sweep = 0; sweep < kSweeps; ++sweep)
    for (std::size_t i = 1; i + 1 < path.size(); ++i) {
      const Joints way = 0.5 * (path[i - 1] + path[i + 1]) - path[i];
      for (double share = 1.0; share >= kLeastPull; share *= 0.5) {
        const Joints tighter = path[i] + share * way;
        if (!passable.along(path[i - 1], tighter) || !passable.along(tighter, path[i + 1])) continue;
        path[i] = tighter;
        break;
      }
    }
}

std::vector<Joints> split(const std::vector<Joints>& path, double longest_rad) {
  std::vector<Joints> points;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Joints way = path[i] - path[i - 1];
    const int parts = std::max(1, static_cast<int>(std::ceil(way.cwiseAbs().maxCoeff() / longest_rad)));
    for (int part = 1; part <= parts; ++part)
      points.push_back(path[i - 1] + (static_cast<double>(part) / parts) * way);
  }
  return points;
}

}  // namespace

std::vector<Joints> shortened(std::vector<Joints> path, const Passable& passable) {
  for (int round = 0; round < kRounds; ++round) path = withMiddles(withoutDetours(path, passable));
  path = withoutDetours(path, passable);
  for (int round = 0; round < kPulls; ++round) {
    path = withMiddles(path);
    pullTight(path, passable);
  }
  return withoutDetours(path, passable);
}

std::vector<Joints> splitEdges(const std::vector<Joints>& path, std::size_t most) {
  double longest_rad = kLongestEdge_rad;
  std::vector<Joints> points = split(path, longest_rad);
  while (points.size() > most && points.size() > path.size() - 1)
    points = split(path, longest_rad *= kLonger);
  return points;
}

}  // namespace mirrorarm::robot
