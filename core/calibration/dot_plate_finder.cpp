#include "core/calibration/dot_plate_finder.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "core/calibration/disc_lattice.h"
#include "core/calibration/dot_identity.h"
#include "core/calibration/dot_pattern.h"
#include "core/calibration/seen_discs.h"

namespace mirrorarm::calibration {
namespace {

constexpr std::size_t kFewest = 9;
/// Diameters against the step: what is smaller or larger is no dot of a plate; between them lies the border
/// of small and large ones.
constexpr double kLeastShare = 0.3, kMostShare = 0.8;

vision::FinderSettings settings() {
  vision::FinderSettings settings;
  settings.max_diameter_px = 100.0;
  return settings;
}

struct Dot {
  SizedDot sized;
  SeenPoint seen;
};

/// Dots of the lattice that are as large as dots may be.
std::vector<Dot> dotsOf(std::span<const PlacedDisc> lattice, std::span<const SeenPoint> discs) {
  const double border = std::sqrt(kSmallDotShare * kLargeDotShare);
  std::vector<Dot> dots;
  for (const auto& placed : lattice) {
    const SeenPoint& disc = discs[placed.disc];
    const double share =
        2.0 * std::sqrt(std::sqrt(disc.shape_px2.determinant()) / std::abs(placed.steps_px.determinant()));
    if (share > kLeastShare && share < kMostShare) dots.push_back({{placed.place, share > border}, disc});
  }
  return dots;
}

}  // namespace

Expected<Sighting, BoardMiss> findDotPlate(const camera::ImageView& image, const Board& plate) {
  const auto discs = seenDiscs(image, settings());
  const auto dots = dotsOf(largestLattice(discs), discs);
  if (dots.size() < kFewest) return unexpected(BoardMiss::kNotFound);
  std::vector<SizedDot> sized;
  for (const auto& dot : dots) sized.push_back(dot.sized);
  const auto place = placeOnPlate(sized, plate);
  if (!place) return unexpected(BoardMiss::kNotFound);
  if (place->is_larger) return unexpected(BoardMiss::kLargerBoard);
  Sighting sighting;
  for (const auto& dot : dots) {
    const Place at = place->onPlate(dot.sized.place);
    const bool is_on_plate = at.x() >= 0 && at.x() < plate.columns && at.y() >= 0 && at.y() < plate.rows;
    if (!is_on_plate || isLargeDot(at.x(), at.y()) != dot.sized.is_large) continue;
    sighting.push_back(dot.seen);
    sighting.back().point = at.y() * plate.columns + at.x();
  }
  std::sort(sighting.begin(), sighting.end(),
            [](const SeenPoint& a, const SeenPoint& b) { return a.point < b.point; });
  return sighting;
}

}  // namespace mirrorarm::calibration
