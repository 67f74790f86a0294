#include "core/calibration/dot_identity.h"

#include <algorithm>
#include <array>
#include <limits>

#include "core/calibration/dot_pattern.h"

namespace mirrorarm::calibration {
namespace {

constexpr int kMargin = 3;             // dots by which the next best place must fit worse
constexpr int kDotsPerError = 16;      // one of so many may be wrong
constexpr int kFewestToBeLarger = 20;  // dots, among all places of a large plate
constexpr int kFewestBeyond = 3;       // of them beyond the wished plate
constexpr int kLargestPlate = 64;      // columns and rows that are looked for

const std::array<Eigen::Matrix2i, 4>& quarterTurns() {
  static const std::array<Eigen::Matrix2i, 4> turns = [] {
    std::array<Eigen::Matrix2i, 4> made;
    made[0].setIdentity();
    Eigen::Matrix2i quarter;
    quarter << 0, -1, 1, 0;
    for (std::size_t i = 1; i < made.size(); ++i) made[i] = quarter * made[i - 1];
    return made;
  }();
  return turns;
}

/// Where a plate's dots may lie.
struct Extent {
  int columns = 0, rows = 0;
  [[nodiscard]] bool holds(const Place& place) const {
    return place.x() >= 0 && place.x() < columns && place.y() >= 0 && place.y() < rows;
  }
};

/// The best place and how the next best compares.
struct Search {
  LatticePlace best;
  int errors = std::numeric_limits<int>::max();
  int next_errors = std::numeric_limits<int>::max();

  void offer(const LatticePlace& place, int wrong) {
    if (wrong < errors) {
      next_errors = errors;
      errors = wrong;
      best = place;
    } else {
      next_errors = std::min(next_errors, wrong);
    }
  }
  /// More errors than that change nothing.
  [[nodiscard]] int enough(int most) const { return std::min(next_errors, most + kMargin); }
};

int errorsAt(std::span<const SizedDot> dots, const LatticePlace& place, const Extent& extent, int enough) {
  int errors = 0;
  for (const auto& dot : dots) {
    const Place at = place.onPlate(dot.place);
    if (!extent.holds(at) || isLargeDot(at.x(), at.y()) != dot.is_large) ++errors;
    if (errors >= enough) break;
  }
  return errors;
}

/// All turns and shifts with no more than `most` columns or rows of the lattice beyond the plate.
Search searchOf(std::span<const SizedDot> dots, const Extent& extent, int most_errors, int overhang) {
  Search search;
  for (const auto& turn : quarterTurns()) {
    Place low = turn * dots.front().place, high = low;
    for (const auto& dot : dots) {
      low = low.cwiseMin(turn * dot.place);
      high = high.cwiseMax(turn * dot.place);
    }
    for (int y = -overhang - low.y(); y + high.y() < extent.rows + overhang; ++y)
      for (int x = -overhang - low.x(); x + high.x() < extent.columns + overhang; ++x) {
        const LatticePlace place{turn, {x, y}, false};
        search.offer(place, errorsAt(dots, place, extent, search.enough(most_errors)));
      }
  }
  return search;
}

bool isSure(const Search& search, int most_errors) {
  return search.errors <= most_errors && search.next_errors >= search.errors + kMargin;
}

}  // namespace

std::optional<LatticePlace> placeOnPlate(std::span<const SizedDot> dots, const Board& plate) {
  if (dots.empty()) return std::nullopt;
  const auto count = static_cast<int>(dots.size());
  const int most_errors = count / kDotsPerError;
  const Extent wished{plate.columns, plate.rows};
  // A light beside the plate can lengthen the lattice by one.
  const Search on_plate = searchOf(dots, wished, most_errors, most_errors > 0 ? 1 : 0);
  if (isSure(on_plate, most_errors)) return on_plate.best;
  if (count < kFewestToBeLarger) return std::nullopt;
  const Search anywhere = searchOf(dots, {kLargestPlate, kLargestPlate}, most_errors, 0);
  if (!isSure(anywhere, most_errors)) return std::nullopt;
  LatticePlace place = anywhere.best;
  const auto beyond = std::count_if(
      dots.begin(), dots.end(), [&](const SizedDot& dot) { return !wished.holds(place.onPlate(dot.place)); });
  place.is_larger = beyond >= kFewestBeyond;
  return place.is_larger ? std::optional(place) : std::nullopt;
}

}  // namespace mirrorarm::calibration
