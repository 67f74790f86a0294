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
/// What is smaller or larger is no dot of a plate, nor what lies elsewhere.
constexpr LatticeLimits kLimits{0.3, 0.8, 0.012, 0.03};

vision::FinderSettings settings() {
  vision::FinderSettings settings;
  settings.max_diameter_px = 100.0;
  return settings;
}

constexpr double kMostSizeError = 0.15;  // of a dot's diameter

struct Dot {
  SizedDot sized;
  double diameter = 0.0;  ///< in steps
  SeenPoint seen;
};

/// Dots of the lattice that are as large as dots may be.
std::vector<Dot> dotsOf(std::span<const PlacedDisc> lattice, std::span<const SeenPoint> discs) {
  const double border = std::sqrt(kSmallDotShare * kLargeDotShare);
  std::vector<Dot> dots;
  for (const auto& placed : lattice) {
    const SeenPoint& disc = discs[placed.disc];
    const double diameter = diameterOf(disc.shape_px2, placed.steps_px);
    if (kLimits.holds(diameter)) dots.push_back({{placed.place, diameter > border}, diameter, disc});
  }
  return dots;
}

/// A light at the place of a hidden dot is hardly of its size too.
bool isDot(const Place& at, double diameter, const Board& plate) {
  if (at.x() < 0 || at.x() >= plate.columns || at.y() < 0 || at.y() >= plate.rows) return false;
  const double expected = isLargeDot(at.x(), at.y()) ? kLargeDotShare : kSmallDotShare;
  return std::abs(diameter / expected - 1.0) < kMostSizeError;
}

}  // namespace

Expected<Sighting, BoardMiss> findDotPlate(const camera::ImageView& image, const Board& plate) {
  const auto discs = seenDiscs(image, settings());
  const auto dots = dotsOf(largestLattice(discs, kLimits), discs);
  if (dots.size() < kFewest) return unexpected(BoardMiss::kNotFound);
  std::vector<SizedDot> sized;
  for (const auto& dot : dots) sized.push_back(dot.sized);
  const auto place = placeOnPlate(sized, plate);
  if (!place) return unexpected(BoardMiss::kNotFound);
  if (place->is_larger) return unexpected(BoardMiss::kLargerBoard);
  Sighting sighting;
  for (const auto& dot : dots) {
    const Place at = place->onPlate(dot.sized.place);
    if (!isDot(at, dot.diameter, plate)) continue;
    sighting.push_back(dot.seen);
    sighting.back().point = at.y() * plate.columns + at.x();
  }
  std::sort(sighting.begin(), sighting.end(),
            [](const SeenPoint& a, const SeenPoint& b) { return a.point < b.point; });
  return sighting;
}

}  // namespace mirrorarm::calibration
