#include "core/tracking/association.h"

#include <algorithm>

namespace mirrorarm::tracking {
namespace {

/// True when a cloud point that is paired already claims a disc of point `y`.
bool isClaimed(std::span<const SeenDiscs> discs_of_y, std::span<const int> y_of_x, int y) {
  if (discs_of_y.empty()) return false;
  const SeenDiscs& discs = discs_of_y[static_cast<std::size_t>(y)];
  return std::any_of(y_of_x.begin(), y_of_x.end(), [&](int paired) {
    return paired >= 0 && shareADisc(discs_of_y[static_cast<std::size_t>(paired)], discs);
  });
}

}  // namespace

int Association::pair(std::span<const Eigen::Vector3d> x, std::span<const Eigen::Vector3d> y,
                      const RigidTransform& X_YX, double gate_m, std::vector<int>& y_of_x,
                      std::span<const SeenDiscs> discs_of_y) {
  pairs_.clear();
  for (std::size_t j = 0; j < x.size(); ++j) {
    const Eigen::Vector3d moved = X_YX * x[j];
    for (std::size_t k = 0; k < y.size(); ++k) {
      const double squared_distance = (y[k] - moved).squaredNorm();
      if (squared_distance <= gate_m * gate_m)
        pairs_.push_back({squared_distance, static_cast<int>(j), static_cast<int>(k)});
    }
  }
  std::sort(pairs_.begin(), pairs_.end(),
            [](const Pair& a, const Pair& b) { return a.squared_distance < b.squared_distance; });
  y_of_x.assign(x.size(), -1);
  taken_.assign(y.size(), 0);
  int matched = 0;
  for (const Pair& p : pairs_) {
    int& partner = y_of_x[static_cast<std::size_t>(p.x)];
    char& taken = taken_[static_cast<std::size_t>(p.y)];
    if (partner >= 0 || taken != 0 || isClaimed(discs_of_y, y_of_x, p.y)) continue;
    partner = p.y;
    taken = 1;
    ++matched;
  }
  return matched;
}

}  // namespace mirrorarm::tracking
