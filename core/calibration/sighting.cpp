#include "core/calibration/sighting.h"

namespace mirrorarm::calibration {

Sighting sightingOf(std::span<const Eigen::Vector2d> pixels) {
  Sighting sighting(pixels.size());
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    sighting[i].point = static_cast<int>(i);
    sighting[i].pixel = pixels[i];
  }
  return sighting;
}

std::vector<std::pair<SeenPoint, SeenPoint>> seenByBoth(const BoardView& view) {
  std::vector<std::pair<SeenPoint, SeenPoint>> both;
  const auto& [first, second] = view.seen;
  auto partner = second.begin();
  for (const auto& seen : first) {
    while (partner != second.end() && partner->point < seen.point) ++partner;
    if (partner == second.end()) break;
    if (partner->point == seen.point) both.emplace_back(seen, *partner);
  }
  return both;
}

}  // namespace mirrorarm::calibration
