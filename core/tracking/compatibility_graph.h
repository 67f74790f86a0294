#pragma once

#include <vector>

#include "core/tracking/bit_sets.h"

namespace mirrorarm::tracking {

/// A marker taken for a point.
struct Pairing {
  int marker = 0;
  int point = 0;
};

/// Which pairings of one target and one cloud agree with each other, as bit sets: for each pairing and each
/// marker the points that this other marker may then be. Pairings that share their marker or their point are
/// never to be joined. Keeps its buffers, and does not clear them: rows are valid where joined() says so.
class CompatibilityGraph {
 public:
  void reset(int markers, int points);
  void join(Pairing one, Pairing other) {
    setNeighbour(one, other);
    setNeighbour(other, one);
  }

  [[nodiscard]] int markers() const { return markers_; }
  [[nodiscard]] int points() const { return points_; }
  /// Markers that have some pairing which agrees with `one`.
  [[nodiscard]] MarkerSet joined(Pairing one) const { return joined_[vertex(one)]; }
  /// Points that `marker` may be when `one` holds; only for a marker in joined(one).
  [[nodiscard]] const PointSet& neighbours(Pairing one, int marker) const { return rowOf(one)[marker]; }
  /// The same for all markers.
  [[nodiscard]] const PointSet* rowOf(Pairing one) const {
    return rows_.data() + vertex(one) * static_cast<std::size_t>(markers_);
  }

 private:
  [[nodiscard]] std::size_t vertex(Pairing one) const {
    return static_cast<std::size_t>(one.marker) * static_cast<std::size_t>(points_) +
           static_cast<std::size_t>(one.point);
  }
  void setNeighbour(Pairing one, Pairing other) {
    const std::size_t row = vertex(one);
    PointSet& points =
        rows_[row * static_cast<std::size_t>(markers_) + static_cast<std::size_t>(other.marker)];
    MarkerSet& joined = joined_[row];
    if ((joined & markerBit(other.marker)) == 0) points = {};
    points |= PointSet::of(other.point);
    joined |= markerBit(other.marker);
  }

  int markers_ = 0;
  int points_ = 0;
  std::vector<MarkerSet> joined_;
  std::vector<PointSet> rows_;
};

}  // namespace mirrorarm::tracking
